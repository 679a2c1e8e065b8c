package particles.output.charts;

import java.awt.Color;
import java.awt.Font;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.LegendItemCollection;
import org.jfree.chart.StandardChartTheme;
import org.jfree.chart.plot.CombinedDomainXYPlot;
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
    /** The height of a row, in pixels as the other charts' heights, roughly. */
    static final int ROW = 17;
    static final int GAP = 14;
    /** The height of a chart above rows, in the same pixels. */
    private static final int MAIN = 400;
    private static final int CELL = 345;
    private static final int UPPERMOST = 255;
    private static final int LOWER = 153;

    private Charts() {
    }

    /**
     * @param panel  one chart, or charts above each other
     * @param title  the font of its title
     * @param narrow whether it is a cell of a grid, with room for few ticks
     */
    static JFreeChart of(Panel panel, Font title, boolean narrow) {
        XYPlot plot = panel.kind() == Panel.Kind.PHASE ? PhasePlot.of(panel)
                : panel.charts().size() == 1 ? new ChartPlot(panel.charts().get(0), panel.kind(), narrow ? 6 : 10, 8)
                : stacked(panel, narrow);
        JFreeChart chart = new JFreeChart(panel.title(), null, plot, false);
        chart.getTitle().setMargin(2, 0, 2, 0);
        TextTitle answer = new TextTitle(panel.answer());
        answer.setMargin(0, 0, 6, 0);
        chart.addSubtitle(answer);
        chart.setPadding(new RectangleInsets(6, 6, 4, 12));
        theme(title).apply(chart);
        return chart;
    }

    private static StandardChartTheme theme(Font title) {
        StandardChartTheme theme = new StandardChartTheme("DESolver");
        theme.setExtraLargeFont(title);
        theme.setLargeFont(ChartStyle.LABEL);
        theme.setRegularFont(ChartStyle.TICKS);
        theme.setTitlePaint(ChartStyle.TEXT);
        theme.setSubtitlePaint(ChartStyle.TEXT);
        theme.setAxisLabelPaint(ChartStyle.TEXT);
        theme.setTickLabelPaint(ChartStyle.TEXT);
        theme.setPlotBackgroundPaint(Color.WHITE);
        theme.setPlotOutlinePaint(ChartStyle.AXIS);
        theme.setDomainGridlinePaint(ChartStyle.GRID);
        theme.setRangeGridlinePaint(ChartStyle.GRID);
        theme.setAxisOffset(RectangleInsets.ZERO_INSETS);
        return theme;
    }

    /** Charts over the x axis of the first. The uppermost one has more room; rows have a fixed height. */
    private static XYPlot stacked(Panel panel, boolean narrow) {
        int ticks = narrow ? 6 : 10;
        Chart first = panel.charts().get(0);
        Range x = panel.charts().stream().map(chart -> ChartPlot.shown(chart, true)).reduce(null, Range::combine);
        CombinedDomainXYPlot all = new CombinedDomainXYPlot(Axes.of(first.x(), x, ChartPlot.onlyLines(first), ticks));
        all.setGap(GAP);
        all.setFixedDomainAxisSpace(Axes.below());
        all.setInsets(RectangleInsets.ZERO_INSETS);
        boolean several = panel.charts().stream().filter(chart -> chart.rows().isEmpty()).count() > 1;
        for (Chart chart : panel.charts()) {
            int rows = chart.rows().size();
            ChartPlot plot = new ChartPlot(chart, panel.kind(), ticks, chart == first ? 8 : 6);
            plot.setFixedDomainAxisSpace(null);
            all.add(plot, rows > 0 ? ROW * (rows + 1) : chart != first ? LOWER : several ? UPPERMOST
                    : narrow ? CELL : MAIN);
        }
        return all;
    }

    static List<ChartPlot> plots(JFreeChart chart) {
        XYPlot plot = chart.getXYPlot();
        return (plot instanceof CombinedDomainXYPlot all ? all.getSubplots() : List.of(plot)).stream()
                .map(ChartPlot.class::cast).toList();
    }

    /** @return the legend of all series whose names are not in their charts; each appears once */
    static LegendTitle legend(List<ChartPlot> plots) {
        LegendItemCollection items = new LegendItemCollection();
        Set<List<Object>> named = new HashSet<>();
        for (ChartPlot plot : plots) {
            ChartDataset data = (ChartDataset) plot.getDataset();
            for (int k = 0; k < data.getSeriesCount(); k++) {
                Series series = data.series(k);
                boolean onlyOne = data.getSeriesCount() == 1 && series.mark() == Mark.BAND;    // the axis names it
                if (!plot.ends.labelled.contains(k) && !series.mark().isDetail() && !onlyOne && series.x().length > 0
                        && named.add(List.of(series.name(), series.mark().isCurve()))) {
                    items.add(plot.getRenderer().getLegendItem(0, k));
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

    static boolean isEmpty(LegendTitle legend) {
        return legend.getSources()[0].getLegendItems().getItemCount() == 0;
    }
}
