package particles.output.charts;

import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import org.jfree.chart.block.RectangleConstraint;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.title.LegendTitle;
import org.jfree.chart.ui.RectangleInsets;
import org.jfree.chart.ui.Size2D;
import org.jfree.data.Range;

/** Small multiples: charts in a grid, under one title; the legend is in a free cell, or below. */
public final class PanelGrid {
    private static final int CELL = 360;
    private static final int CHART_CELL = 500;
    /** With two columns there is room for the names of rows and of lines, too. */
    private static final int WIDE_CELL = 720;
    private static final int LEAST_WIDTH = 1100;
    /** The height of a chart above rows. */
    private static final int MAIN = 250;
    private static final double TALL = 1.5;
    /** Taller maps are narrower than their cells. */
    private static final double TALLEST_SHAPE = 2.4;
    private static final double AXES = 0.85;
    private static final double HEIGHT_OF_WIDTH = 0.6;
    private static final int LINE = 21;
    private static final int MARGIN = 10;
    private static final int TALLEST = 400;
    private static final int TRIALS = 8;

    private final String title;
    private final int columns;
    private final List<FittedChart> charts;
    private final LegendTitle legend;
    private final int width;
    private final double cellWidth;
    /** The tops of the rows below the title, and the bottom of the last one. */
    private final double[] tops;
    private final boolean legendInCell;
    private final boolean compared;

    /**
     * @param title  the title over all panels
     * @param panels the panels, row by row
     */
    public PanelGrid(String title, List<Panel> panels) {
        this.title = title;
        charts = panels.stream().map(panel -> Charts.of(panel, MAIN)).toList();
        legend = ChartLegend.of(charts.stream().flatMap(chart -> FittedChart.subplots(chart.getXYPlot()).stream())
                .sorted(Comparator.comparing((XYPlot plot) -> -plot.getDataset().getSeriesCount())).toList(),
                charts.stream().flatMap(chart -> chart.labelledNames().stream()).toList(), true);
        for (FittedChart chart : charts) {
            chart.removeLegend();
            chart.getTitle().setFont(ChartStyle.PANEL);
            chart.setPadding(new RectangleInsets(4, 4, 4, 8));
        }
        boolean round = charts.stream().allMatch(FittedChart::hasEqualUnits);
        double shape = round ? Math.min(TALLEST_SHAPE, shape(charts.get(0).getXYPlot())) : 1;
        compared = panels.stream().allMatch(panel ->
                panel.charts().get(0).scale().equals(panels.get(0).charts().get(0).scale()));
        columns = shape > TALL ? panels.size() : columns(panels.size());
        int rows = (charts.size() + columns - 1) / columns;
        width = Math.max(LEAST_WIDTH, columns * (round ? CELL : columns > 2 ? CHART_CELL : WIDE_CELL));
        cellWidth = (width - 2.0 * MARGIN) / columns;
        double cellHeight = (round ? 1.02 + AXES * (shape - 1) : HEIGHT_OF_WIDTH) * cellWidth;
        tops = new double[rows + 1];
        for (int row = 0; row < rows; row++) {
            int tallest = panels.stream().skip((long) row * columns).limit(columns)
                    .flatMap(panel -> panel.charts().stream()).mapToInt(data -> data.rows().size()).max().orElse(0);
            tops[row + 1] = tops[row] + cellHeight + (tallest == 0 ? 0 : Charts.ROW * (tallest + 1));
        }
        legendInCell = rows * columns > charts.size();
    }

    /** @return the number of panels in a row; rows are full if possible */
    static int columns(int panels) {
        return panels <= 3 ? panels : panels % 4 == 0 && panels > 4 ? 4 : panels % 3 == 0 || panels > 4 ? 3 : 2;
    }

    /** @return the height of a map over its width */
    private static double shape(XYPlot map) {
        return map.getRangeAxis().getRange().getLength() / map.getDomainAxis().getRange().getLength();
    }

    /** Pads charts on the same axes until their frames are equal: text around them takes different room. */
    private void alignPanels(Graphics2D g) {
        for (int trial = 0; trial < TRIALS; trial++) {
            List<Rectangle2D> frames = IntStream.range(0, charts.size()).mapToObj(k -> charts.get(k).frame(g,
                    new Rectangle2D.Double(0, 0, cellWidth, height(k / columns)))).toList();
            Rectangle2D common = frames.stream().reduce(Rectangle2D::createIntersection).orElseThrow();
            for (int k = 0; k < charts.size(); k++) {
                RectangleInsets padding = charts.get(k).getPadding();
                Rectangle2D frame = frames.get(k);
                charts.get(k).setPadding(new RectangleInsets(padding.getTop() + common.getMinY() - frame.getMinY(),
                        padding.getLeft() + common.getMinX() - frame.getMinX(),
                        padding.getBottom() + frame.getMaxY() - common.getMaxY(),
                        padding.getRight() + frame.getMaxX() - common.getMaxX()));
            }
        }
    }

    private double height(int row) {
        return tops[row + 1] - tops[row];
    }

    /** @return the page with all panels */
    public ChartPage page() {
        Graphics2D trial = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB).createGraphics();
        List<String> lines = ChartStyle.wrapped(title, trial.getFontMetrics(ChartStyle.TITLE), width - 4.0 * MARGIN);
        if (compared) {
            alignPanels(trial);
        }
        Size2D size = legend.arrange(trial, new RectangleConstraint(new Range(0, legendInCell
                ? cellWidth : width - 2.0 * MARGIN), new Range(0, TALLEST)));
        trial.dispose();
        double head = LINE * (lines.size() + 1);
        int last = tops.length - 2;
        double bottom = head + tops[last + 1];
        int height = (int) Math.ceil(bottom + (legendInCell ? 0 : size.height) + MARGIN);
        return new ChartPage(width, height, false, g -> {
            g.setColor(Color.WHITE);
            g.fill(new Rectangle2D.Double(0, 0, width, height));
            g.setColor(ChartStyle.TEXT);
            g.setFont(ChartStyle.TITLE);
            FontMetrics metrics = g.getFontMetrics();
            for (int k = 0; k < lines.size(); k++) {
                g.drawString(lines.get(k), (float) (width - metrics.getStringBounds(lines.get(k), g).getWidth()) / 2,
                        (k + 1.2f) * LINE);
            }
            for (int k = 0; k < charts.size(); k++) {
                charts.get(k).draw(g, new Rectangle2D.Double(MARGIN + k % columns * cellWidth,
                        head + tops[k / columns], cellWidth, height(k / columns)));
            }
            double left = legendInCell ? MARGIN + (columns - 1) * cellWidth + (cellWidth - size.width) / 2
                    : (width - size.width) / 2;
            double top = legendInCell ? head + (tops[last] + tops[last + 1] - size.height) / 2 : bottom;
            legend.draw(g, new Rectangle2D.Double(left, top, size.width, size.height));
        });
    }
}
