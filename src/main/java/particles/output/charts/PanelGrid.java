package particles.output.charts;

import java.awt.Graphics2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.Arrays;
import java.util.List;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.plot.Plot;
import org.jfree.chart.plot.PlotRenderingInfo;
import org.jfree.chart.plot.PlotState;
import org.jfree.chart.title.LegendTitle;
import particles.view.Panel;

/** Small multiples: charts in the cells of a grid, under one title, with one legend below. */
public final class PanelGrid extends Plot {
    private static final long serialVersionUID = 1L;
    private static final int ROUND_CELL = 360;
    /** There is room for the names of rows and of lines, too. */
    private static final int CELL = 720;
    private static final double HEIGHT_OF_WIDTH = 0.6;
    /** The height of a panel's title, answer and axis. */
    private static final int HEAD_AND_AXIS = 100;
    /** The height of the title of all, and that of the legend. */
    private static final int LINE = 36;

    private final transient List<JFreeChart> charts;
    private final int columns;
    /** The height of what is below each chart, which is as large as the others without them. */
    private final int[] named;

    private PanelGrid(List<JFreeChart> charts, int columns, int[] named) {
        this.charts = charts;
        this.columns = columns;
        this.named = named;
    }

    /** @return the number of panels in a row; rows are full if possible */
    static int columns(int panels) {
        return panels < 4 ? panels : panels % 4 == 0 ? 4 : 3;
    }

    /**
     * @param title  the title over all panels
     * @param panels the panels, row by row
     * @param format the format of the picture
     * @return the page
     */
    public static ChartPage page(String title, List<Panel> panels, ChartFormat format) {
        List<JFreeChart> charts = panels.stream().map(panel -> Charts.of(panel, true, format)).toList();
        List<ChartPlot> plots = charts.stream().flatMap(chart -> Charts.plots(chart).stream()).toList();
        double left = plots.stream().mapToDouble(plot -> plot.beside.getLeft()).max().orElse(0);
        double right = plots.stream().mapToDouble(plot -> plot.beside.getRight()).max().orElse(0);
        plots.forEach(plot -> plot.setRoom(left, right));       // so that frames are of one size
        boolean round = plots.stream().allMatch(plot -> plot.round);
        double shape = plots.get(0).getRangeAxis().getRange().getLength()
                / plots.get(0).getDomainAxis().getRange().getLength();
        int columns = right > 0 ? Math.min(2, panels.size()) : columns(panels.size());
        int cell = round ? ROUND_CELL : CELL;
        int[] named = panels.stream().mapToInt(Charts::heightAdded).toArray();
        double high = largest(named) + (round ? shape * (cell - left) + HEAD_AND_AXIS : HEIGHT_OF_WIDTH * cell);
        PanelGrid grid = new PanelGrid(charts, columns, named);
        LegendTitle legend = Charts.legend(plots, format);
        return Charts.page(Charts.titled(title, "", grid, false, format), legend, columns * cell,
                (int) (grid.rows() * high) + (Charts.isEmpty(legend) ? LINE : 2 * LINE));
    }

    private int rows() {
        return (charts.size() + columns - 1) / columns;
    }

    private static int largest(int[] heights) {
        return Arrays.stream(heights).max().orElse(0);
    }

    @Override
    public void draw(Graphics2D g, Rectangle2D area, Point2D anchor, PlotState state, PlotRenderingInfo info) {
        double width = area.getWidth() / columns;
        double height = area.getHeight() / rows();
        for (int k = 0; k < charts.size(); k++) {
            charts.get(k).draw(g, new Rectangle2D.Double(area.getX() + k % columns * width,
                    area.getY() + k / columns * height, width, height - largest(named) + named[k]));
        }
    }

    @Override
    public String getPlotType() {
        return "grid of charts";
    }
}
