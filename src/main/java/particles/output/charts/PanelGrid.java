package particles.output.charts;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.List;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.block.RectangleConstraint;
import org.jfree.chart.title.LegendTitle;
import org.jfree.chart.title.TextTitle;
import org.jfree.chart.title.Title;
import org.jfree.chart.ui.Size2D;
import org.jfree.data.Range;
import particles.view.Panel;

/** Small multiples: charts in a grid, under one title; the legend is below. */
public final class PanelGrid {
    private static final int ROUND_CELL = 360;
    private static final int CELL = 500;
    /** With two columns there is room for the names of rows and of lines, too. */
    private static final int WIDE_CELL = 720;
    private static final int LEAST_WIDTH = 1100;
    private static final double HEIGHT_OF_WIDTH = 0.6;
    /** Taller maps are narrower than their cells, and stand beside each other. */
    private static final double TALLEST = 2.4;
    private static final double TALL = 1.5;
    /** The height of a title, an answer and an axis. */
    private static final int HEAD_AND_AXIS = 100;
    private static final int MARGIN = 10;

    private PanelGrid() {
    }

    /** @return the number of panels in a row; rows are full if possible */
    static int columns(int panels) {
        return panels <= 3 ? panels : panels % 4 == 0 && panels > 4 ? 4 : panels % 3 == 0 || panels > 4 ? 3 : 2;
    }

    /**
     * @param title  the title over all panels
     * @param panels the panels, row by row
     * @return the page
     */
    public static ChartPage page(String title, List<Panel> panels) {
        List<JFreeChart> charts = panels.stream().map(panel -> Charts.of(panel, ChartStyle.PANEL, true)).toList();
        List<ChartPlot> plots = charts.stream().flatMap(chart -> Charts.plots(chart).stream()).toList();
        double left = plots.stream().mapToDouble(plot -> plot.getRoom().getLeft()).max().orElse(0);
        double right = plots.stream().mapToDouble(plot -> plot.getRoom().getRight()).max().orElse(0);
        plots.forEach(plot -> plot.setRoom(left, right));       // so that frames are of one size
        Range x = plots.get(0).getDomainAxis().getRange();
        boolean round = plots.stream().allMatch(ChartPlot::isRound);
        double shape = plots.get(0).getRangeAxis().getRange().getLength() / x.getLength();
        int columns = round && shape > TALL ? panels.size() : columns(panels.size());
        int width = Math.max(LEAST_WIDTH, columns * (round ? ROUND_CELL : columns > 2 ? CELL : WIDE_CELL));
        double cell = (width - 2.0 * MARGIN) / columns;
        Graphics2D trial = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB).createGraphics();
        RectangleConstraint room = new RectangleConstraint(new Range(0, width), new Range(0, width));
        TextTitle heading = new TextTitle(title, ChartStyle.TITLE);
        heading.setPaint(ChartStyle.TEXT);
        Size2D head = heading.arrange(trial, room);
        LegendTitle legend = Charts.legend(plots);
        Size2D foot = legend.arrange(trial, room);
        trial.dispose();
        int rows = (panels.size() + columns - 1) / columns;
        double[] tops = new double[rows + 1];
        tops[0] = head.height + 2 * MARGIN;
        double plain = round ? Math.min(TALLEST, shape) * (cell - left) + HEAD_AND_AXIS : HEIGHT_OF_WIDTH * cell;
        double[] heights = panels.stream().mapToDouble(panel -> plain + panel.charts().stream().mapToInt(data ->
                data.rows().isEmpty() ? 0 : Charts.ROW * (data.rows().size() + 1) + Charts.GAP).sum()).toArray();
        for (int row = 0; row < rows; row++) {
            tops[row + 1] = tops[row] + Arrays.stream(heights).skip((long) row * columns).limit(columns).max()
                    .orElse(0);
        }
        int height = (int) Math.ceil(tops[rows] + (Charts.isEmpty(legend) ? 0 : foot.height) + MARGIN);
        return new ChartPage(width, height, false, g -> {
            g.setColor(Color.WHITE);
            g.fill(new Rectangle2D.Double(0, 0, width, height));
            draw(heading, g, head, width, MARGIN);
            for (int k = 0; k < charts.size(); k++) {
                charts.get(k).draw(g, new Rectangle2D.Double(MARGIN + k % columns * cell, tops[k / columns], cell,
                        heights[k]));
            }
            draw(legend, g, foot, width, tops[rows]);
        });
    }

    private static void draw(Title title, Graphics2D g, Size2D size, double width, double top) {
        title.draw(g, new Rectangle2D.Double((width - size.width) / 2, top, size.width, size.height));
    }
}
