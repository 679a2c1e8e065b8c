package particles.output.charts;

import java.awt.Shape;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import org.jfree.chart.LegendItem;
import org.jfree.chart.LegendItemCollection;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.XYLineAndShapeRenderer;
import org.jfree.chart.title.LegendTitle;
import org.jfree.chart.ui.RectangleEdge;
import org.jfree.chart.ui.RectangleInsets;

/**
 * The legend of a chart: one item for each series, with its line and its points. There is none for a series
 * whose name is in the chart; for the filled region of a solver, as "rk4: stable", whose line has one; and for a single
 * series, unless it is that of a solver or of failures, which the axis does not name.
 */
final class ChartLegend {
    private ChartLegend() {
    }

    static void addTo(FittedChart chart, XYPlot plot) {
        LegendTitle legend = of(FittedChart.subplots(plot), chart.labelledNames(), false);
        if (legend.getSources()[0].getLegendItems().getItemCount() > 0) {
            chart.addLegend(legend);
        }
    }

    /**
     * @param plots   the charts that it explains
     * @param inChart names that stand in the charts
     * @param oneLook whether a name has the same style in all charts; otherwise only solvers and failures have
     * @return the legend; a name with the same style appears once
     */
    static LegendTitle of(List<XYPlot> plots, List<String> inChart, boolean oneLook) {
        LegendItemCollection items = new LegendItemCollection();
        Set<String> named = new HashSet<>();
        for (XYPlot part : plots) {
            ChartDataset dataset = (ChartDataset) part.getDataset();
            for (int k = 0; k < dataset.getSeriesCount(); k++) {
                XYLineAndShapeRenderer renderer = (XYLineAndShapeRenderer) part.getRenderer();
                String name = dataset.name(k);
                Shape shape = renderer.lookupSeriesShape(k);
                boolean failure = shape == ChartStyle.FAILURE || shape == ChartStyle.GIVEN_UP;
                boolean known = failure || SolverStyle.of(name).isPresent();
                boolean alone = dataset.getSeriesCount() == 1 && !known;
                boolean nothing = dataset.getItemCount(k) == 0 && !renderer.getItemShapeVisible(k, 0);
                boolean same = oneLook || known;
                boolean inside = IntStream.range(0, dataset.getSeriesCount()).anyMatch(other ->
                        name.startsWith(dataset.name(other) + ":"));
                if (!alone && !nothing && !inside && !inChart.contains(name) && (!same || named.add(name))) {
                    items.add(item(renderer, k));
                }
            }
        }
        LegendTitle legend = new LegendTitle(() -> items);
        legend.setItemFont(ChartStyle.LABEL);
        legend.setItemPaint(ChartStyle.TEXT);
        legend.setPosition(RectangleEdge.BOTTOM);
        legend.setItemLabelPadding(new RectangleInsets(2, 4, 2, 14));
        return legend;
    }

    /** A line so dense that it is drawn thin and pale has a wide sample: its turns together look like that. */
    private static LegendItem item(XYLineAndShapeRenderer renderer, int k) {
        LegendItem item = renderer.getLegendItem(0, k);
        if (item.getLineStroke() == ChartStyle.THIN) {
            item.setLineStroke(ChartStyle.BAND);
        }
        return item;
    }
}
