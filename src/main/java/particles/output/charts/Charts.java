package particles.output.charts;

import java.awt.BasicStroke;
import java.awt.Color;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Iterator;
import java.util.List;
import org.jfree.chart.axis.LogAxis;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.axis.NumberTickUnitSource;
import org.jfree.chart.axis.SymbolAxis;
import org.jfree.chart.axis.ValueAxis;
import org.jfree.chart.plot.CombinedDomainXYPlot;
import org.jfree.chart.plot.SeriesRenderingOrder;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.title.TextTitle;
import org.jfree.chart.ui.RectangleInsets;
import org.jfree.data.Range;
import org.jfree.data.general.DatasetUtils;
import particles.view.ChartData;
import particles.view.ChartData.Mark;
import particles.view.ChartData.Series;

/** Makes JFreeChart charts of chart data, in the common style. */
final class Charts {
    /** Values that differ by less than this part of their size differ by round-off, which needs no axis of its own. */
    private static final double ROUNDING = 1e-13;

    /** An axis that begins this near to zero, as a part of its end, begins at zero. */
    private static final double NEAR_ZERO = 0.1;

    /** The height of a row, in pixels as the other charts' heights, roughly. */
    static final int ROW = 17;

    private static final int MAIN = 400;

    private Charts() {
    }

    /** @return a chart by itself */
    static FittedChart of(ChartData data) {
        return of(Panel.chart(data));
    }

    /** @return the chart of a panel, or its charts above each other */
    static FittedChart of(Panel panel) {
        return of(panel, MAIN);
    }

    /** @param main the height of a chart above rows, in the same pixels as theirs */
    static FittedChart of(Panel panel, int main) {
        return panel.kind() == Panel.Kind.PHASE ? PhasePlot.of(panel.charts().get(0), panel.field())
                : finished(panel.title(), panel.charts().size() == 1 ? plot(panel.charts().get(0))
                : stacked(panel.charts(), main), panel.kind());
    }

    /**
     * Makes charts above each other, over the x axis of the first. The upper one has more room; rows have a fixed
     * height.
     */
    private static XYPlot stacked(List<ChartData> data, int main) {
        Range x = data.stream().map(chart -> range(new ChartDataset(chart), true)).reduce(null, Range::combine);
        CombinedDomainXYPlot all = new CombinedDomainXYPlot(axis(data.get(0).xLabel(), data.get(0).xLog(), x,
                onlyLines(data.get(0))));
        all.setGap(14);
        long ofQuantities = data.stream().filter(chart -> chart.rows().isEmpty()).count();
        int looks = 0;                                  // the legend is one: no look stands for two series
        for (int k = 0; k < data.size(); k++) {
            int rows = data.get(k).rows().size();
            int series = data.get(k).series().size();
            all.add(plot(data.get(k), series > 1 ? looks : 0), rows > 0 ? ROW * (rows + 1) : k > 0 ? 153
                    : ofQuantities > 1 ? 255 : main);
            looks += series;
        }
        if (data.stream().anyMatch(Charts::isPart)) {
            all.getDomainAxis().setRange(stacked(data.stream().map(Charts::whole).toList(), main).getDomainAxis()
                    .getRange());
        }
        return all;
    }

    private static boolean isPart(ChartData data) {
        return data.scale() != data.series();
    }

    /** What is drawn if nothing is left out. */
    private static ChartData whole(ChartData data) {
        return data.with(data.rows(), data.scale());
    }

    static FittedChart finished(String title, XYPlot plot, Panel.Kind kind) {
        FittedChart chart = new FittedChart(title, plot, kind);
        chart.setBackgroundPaint(Color.WHITE);
        chart.setPadding(new RectangleInsets(8, 8, 8, 14));
        chart.setTextAntiAlias(true);
        TextTitle heading = chart.getTitle();
        heading.setPaint(ChartStyle.TEXT);
        heading.setMargin(2, 0, 6, 0);
        ChartLegend.addTo(chart, plot);
        return chart;
    }

    static XYPlot plot(ChartData data) {
        return plot(data, 0);
    }

    private static XYPlot plot(ChartData given, int firstLook) {
        ChartData data = solidFirst(given);
        ChartDataset dataset = new ChartDataset(data);
        XYPlot plot = new XYPlot(dataset, axis(data.xLabel(), data.xLog(), range(dataset, true), onlyLines(data)),
                data.rows().isEmpty() ? axis(data.yLabel(), data.yLog(), range(dataset, false), false)
                        : inStyle(rowAxis(data.rows()), data.yLabel()), SeriesRenderer.of(data, firstLook));
        plot.setSeriesRenderingOrder(SeriesRenderingOrder.FORWARD);     // through dashes the line below is seen
        plot.setBackgroundPaint(Color.WHITE);
        plot.setDomainGridlinePaint(ChartStyle.GRID);
        plot.setRangeGridlinePaint(ChartStyle.GRID);
        plot.setDomainGridlineStroke(new BasicStroke(0.7f));
        plot.setRangeGridlineStroke(new BasicStroke(0.7f));
        plot.setOutlinePaint(ChartStyle.AXIS);
        plot.setAxisOffset(RectangleInsets.ZERO_INSETS);
        if (isPart(given)) {
            XYPlot whole = plot(whole(given));
            plot.getDomainAxis().setRange(whole.getDomainAxis().getRange());
            if (given.rows().isEmpty()) {
                plot.getRangeAxis().setRange(whole.getRangeAxis().getRange());
            }
        }
        return plot;
    }

    /** Puts solvers with dashed lines after those with solid ones, since the line below shows through dashes. */
    private static ChartData solidFirst(ChartData data) {
        List<Series> solvers = new ArrayList<>(data.series().stream().filter(Charts::isSolverLine).toList());
        solvers.sort(Comparator.comparing(series -> SolverStyle.orGrey(series.name()).hasDashes()));
        Iterator<Series> next = solvers.iterator();
        return data.with(data.rows(), data.series().stream()
                .map(series -> isSolverLine(series) ? next.next() : series).toList());
    }

    private static boolean isSolverLine(Series series) {
        return (series.mark() == Mark.LINE || series.mark() == Mark.LINE_AND_POINTS)
                && SolverStyle.of(series.name()).isPresent();
    }

    /** The range of a dataset; null if it has no point, as JFreeChart expects. */
    private static Range range(ChartDataset dataset, boolean x) {
        return x ? DatasetUtils.findDomainBounds(dataset) : DatasetUtils.findRangeBounds(dataset);
    }

    private static boolean onlyLines(ChartData data) {
        return data.series().stream().allMatch(series -> series.mark() == Mark.LINE || series.mark() == Mark.FAILURES);
    }

    /** Tight: from the first point to the last, without a margin, as marks need it. */
    private static ValueAxis axis(String label, boolean log, Range range, boolean tight) {
        ValueAxis axis = log ? logAxis(range) : linearAxis(range);
        if (tight) {
            axis.setLowerMargin(0);
            axis.setUpperMargin(0);
            if (!log && range != null && range.getLowerBound() > 0
                    && range.getLowerBound() < NEAR_ZERO * range.getUpperBound()) {
                axis.setRange(0, range.getUpperBound());
            }
        }
        return inStyle(axis, label);
    }

    private static ValueAxis inStyle(ValueAxis axis, String label) {
        axis.setLabel(label);
        axis.setLabelFont(ChartStyle.LABEL);
        axis.setLabelPaint(ChartStyle.TEXT);
        axis.setTickLabelFont(ChartStyle.TICKS);
        axis.setTickLabelPaint(ChartStyle.TEXT);
        axis.setAxisLinePaint(ChartStyle.AXIS);
        axis.setTickMarkPaint(ChartStyle.AXIS);
        return axis;
    }

    /** Ticks at powers of ten; an axis that would show less than two of them is widened to whole decades. */
    private static ValueAxis logAxis(Range range) {
        LogAxis axis = new DecadeAxis();
        axis.setStandardTickUnits(new NumberTickUnitSource(true));
        axis.setSmallestValue(Double.MIN_NORMAL);
        if (range != null) {
            double low = Math.floor(Math.log10(range.getLowerBound()) + ROUNDING);
            double high = Math.ceil(Math.log10(range.getUpperBound()) - ROUNDING);
            if (high - low < 3) {
                axis.setRange(Math.pow(10, low), Math.pow(10, Math.max(high, low + 1)));
            }
        }
        return axis;
    }

    /** A name for each row, the first one above. */
    private static ValueAxis rowAxis(List<String> rows) {
        SymbolAxis axis = new SymbolAxis("", rows.toArray(new String[0]));
        axis.setGridBandsVisible(false);
        axis.setInverted(true);
        axis.setRange(-0.8, rows.size() - 0.2);
        return axis;
    }

    private static ValueAxis linearAxis(Range range) {
        NumberAxis axis = new DecimalAxis();
        axis.setAutoRangeIncludesZero(false);
        axis.setAutoRangeStickyZero(false);
        if (range != null) {
            double size = Math.max(Math.abs(range.getLowerBound()), Math.abs(range.getUpperBound()));
            axis.setAutoRangeMinimumSize(size == 0 ? 1 : Math.max(ROUNDING * size, Double.MIN_NORMAL));
        }
        return axis;
    }
}
