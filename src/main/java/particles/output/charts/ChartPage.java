package particles.output.charts;

import java.awt.Graphics2D;
import java.util.function.Consumer;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.title.LegendTitle;
import org.jfree.chart.ui.RectangleEdge;
import particles.view.Panel;

/**
 * A page to be drawn.
 *
 * @param width   the width, in pixels of the layout
 * @param height  the height
 * @param drawing draws the page
 */
public record ChartPage(int width, int height, Consumer<Graphics2D> drawing) {
    private static final int WIDTH = 900;
    private static final int HEIGHT = 560;
    private static final int STACKED_HEIGHT = 760;
    private static final int SQUARE_WIDTH = 720;
    private static final int SQUARE_HEIGHT = 700;

    /**
     * @param panel  the chart
     * @param format the format of the picture
     * @return a page with one chart, or charts above each other
     */
    public static ChartPage of(Panel panel, ChartFormat format) {
        JFreeChart chart = Charts.of(panel, false, format);
        boolean round = Charts.plots(chart).stream().allMatch(plot -> plot.round);
        LegendTitle legend = Charts.legend(Charts.plots(chart), format);
        if (round && format.slide()) {                  // below a round chart on a wide page it would make that small
            legend.setPosition(RectangleEdge.RIGHT);
        }
        long ofQuantities = panel.charts().stream().filter(data -> data.rows().isEmpty()).count();
        return Charts.page(chart, legend, format.width(round ? SQUARE_WIDTH : WIDTH),
                format.height(round ? SQUARE_HEIGHT : (ofQuantities > 1 ? STACKED_HEIGHT : HEIGHT)
                + Charts.heightAdded(panel)));
    }
}
