package particles.output.charts;

import java.awt.Color;
import java.awt.geom.Rectangle2D;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.LegendItemCollection;
import org.jfree.chart.StandardChartTheme;
import org.jfree.chart.plot.CombinedDomainXYPlot;
import org.jfree.chart.plot.Plot;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.title.LegendTitle;
import org.jfree.chart.title.TextTitle;
import org.jfree.chart.ui.RectangleEdge;
import org.jfree.chart.ui.RectangleInsets;
import org.jfree.data.Range;
import particles.view.Chart;
import particles.view.Panel;
import particles.view.Series;
import particles.view.Series.Mark;

/** Makes JFreeChart charts of panels, in the common style. */
final class Charts {
    /** The height of a row, in pixels as the other charts' heights, at least. */
    private static final int ROW = 17;
    private static final int GAP = 14;
    /** The height of a chart above rows, in the same pixels. */
    private static final int MAIN = 400;
    private static final int CELL = 345;
    private static final int UPPERMOST = 255;
    private static final int LOWER = 153;

    private Charts() {
    }

    /**
     * @param panel  one chart, or charts above each other
     * @param narrow whether it is a cell of a grid, with small type and room for few ticks
     * @param format the format of the picture
     */
    static JFreeChart of(Panel panel, boolean narrow, ChartFormat format) {
        XYPlot plot = panel.kind() == Panel.Kind.PHASE ? PhasePlot.of(panel, format)
                : panel.charts().size() == 1 ? new ChartPlot(panel.charts().get(0), panel.kind(), narrow ? 5 : 8, 8,
                format) : stacked(panel, narrow, format);
        return titled(panel.title(), panel.answer(), plot, narrow, format);
    }

    static JFreeChart titled(String title, String answer, Plot plot, boolean narrow, ChartFormat format) {
        JFreeChart chart = new JFreeChart(title, null, plot, false);
        TextTitle below = new TextTitle(answer);
        below.setMargin(0, 0, 6, 0);
        chart.addSubtitle(below);
        chart.setPadding(new RectangleInsets(6, 6, 4, 12));
        StandardChartTheme theme = new StandardChartTheme("DESolver");
        theme.setExtraLargeFont(narrow ? ChartStyle.PANEL : ChartStyle.TITLE);
        theme.setLargeFont(ChartStyle.LABEL);
        theme.setRegularFont(ChartStyle.TICKS);
        Color text = format.on(ChartStyle.TEXT);
        theme.setTitlePaint(text);
        theme.setSubtitlePaint(text);
        theme.setAxisLabelPaint(text);
        theme.setTickLabelPaint(text);
        theme.setChartBackgroundPaint(format.on(Color.WHITE));
        theme.setPlotBackgroundPaint(format.on(Color.WHITE));
        theme.setPlotOutlinePaint(format.on(ChartStyle.AXIS));
        theme.setDomainGridlinePaint(format.on(ChartStyle.GRID));
        theme.setRangeGridlinePaint(format.on(ChartStyle.GRID));
        theme.setAxisOffset(RectangleInsets.ZERO_INSETS);
        theme.apply(chart);
        return chart;
    }

    /** @return a page with a chart, and its legend if that has entries */
    static ChartPage page(JFreeChart chart, LegendTitle legend, int width, int height) {
        if (!isEmpty(legend)) {
            chart.addLegend(legend);
        }
        return new ChartPage(width, height, g -> chart.draw(g, new Rectangle2D.Double(0, 0, width, height)));
    }

    /** Charts over the x axis of the first. The uppermost one has more room; rows have a fixed height. */
    private static XYPlot stacked(Panel panel, boolean narrow, ChartFormat format) {
        int ticks = narrow ? 5 : 8;
        Chart first = panel.charts().get(0);
        Range x = panel.charts().stream().map(chart -> ChartPlot.shown(chart, true)).reduce(null, Range::combine);
        CombinedDomainXYPlot all = new CombinedDomainXYPlot(Axes.of(first.x(), x, ChartPlot.onlyLines(first), ticks));
        all.setGap(GAP);
        all.setFixedDomainAxisSpace(Axes.below());
        all.setInsets(RectangleInsets.ZERO_INSETS);
        boolean several = panel.charts().stream().filter(chart -> chart.rows().isEmpty()).count() > 1;
        for (Chart chart : panel.charts()) {
            ChartPlot plot = new ChartPlot(chart, panel.kind(), ticks, chart == first ? 8 : 6, format);
            plot.setFixedDomainAxisSpace(null);
            all.add(plot, chart != first ? heightBelow(chart) : several ? UPPERMOST : narrow ? CELL : MAIN);
        }
        return all;
    }

    /** @return the height that charts of rows, and those of a third and further quantities, add to a page */
    static int heightAdded(Panel panel) {
        Stream<Chart> quantities = panel.charts().stream().filter(chart -> chart.rows().isEmpty()).skip(2);
        Stream<Chart> rows = panel.charts().stream().filter(chart -> !chart.rows().isEmpty());
        return Stream.concat(quantities, rows).mapToInt(chart -> GAP + heightBelow(chart)).sum();
    }

    /** The height of a chart below another one: at least the length of its label, which stands upright beside it. */
    private static int heightBelow(Chart chart) {
        return Math.max(chart.rows().isEmpty() ? LOWER : ROW * (chart.rows().size() + 1),
                (int) Axes.width(ChartStyle.LABEL, chart.y().label()));
    }

    static List<ChartPlot> plots(JFreeChart chart) {
        XYPlot plot = chart.getXYPlot();
        return (plot instanceof CombinedDomainXYPlot all ? all.getSubplots() : List.of(plot)).stream()
                .map(ChartPlot.class::cast).toList();
    }

    /**
     * @return the legend of all series with points whose names are not in their charts, first the curves of solvers;
     *         each appears once
     */
    static LegendTitle legend(List<ChartPlot> plots, ChartFormat format) {
        LegendItemCollection items = new LegendItemCollection();
        LegendItemCollection besides = new LegendItemCollection();      // what is drawn in every panel
        Set<List<Object>> named = new HashSet<>();
        for (ChartPlot plot : plots) {
            ChartDataset data = (ChartDataset) plot.getDataset();
            for (int k = 0; k < data.getSeriesCount(); k++) {
                Series series = data.series(k);
                boolean onlyOne = data.getSeriesCount() == 1 && series.mark() == Mark.FILL;    // the axis names it
                if (!plot.ends.labelled.contains(k) && !onlyOne && data.last(k) >= 0
                        && named.add(List.of(series.name(), series.mark().isCurve()))) {
                    (series.mark().isCurve() && !series.look().isReference() ? items : besides)
                            .add(plot.getRenderer().getLegendItem(0, k));
                }
            }
        }
        items.addAll(besides);
        LegendTitle legend = new LegendTitle(() -> items);
        legend.setPosition(RectangleEdge.BOTTOM);
        legend.setItemFont(ChartStyle.LABEL);
        legend.setItemPaint(format.on(ChartStyle.TEXT));
        legend.setItemLabelPadding(new RectangleInsets(2, 4, 2, 14));
        return legend;
    }

    static boolean isEmpty(LegendTitle legend) {
        return legend.getSources()[0].getLegendItems().getItemCount() == 0;
    }
}
