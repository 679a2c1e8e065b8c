package particles.output.charts;

import java.awt.BasicStroke;
import java.awt.Color;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Iterator;
import java.util.List;
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

    /** The part of its range that an axis shows beyond the first and the last point. */
    private static final double MARGIN = 0.05;

    /** The height of a row, in pixels as the other charts' heights, roughly. */
    static final int ROW = 17;

    private static final int MAIN = 400;

    private Charts() {
    }

    /** @return the chart of a panel, or its charts above each other */
    static FittedChart of(Panel panel) {
        return of(panel, MAIN);
    }

    /** @param main the height of a chart above rows, in the same pixels as theirs */
    static FittedChart of(Panel panel, int main) {
        return panel.kind() == Panel.Kind.PHASE ? PhasePlot.of(panel.charts().get(0), panel.field())
                : finished(panel.title(), panel.charts().size() == 1 ? plot(panel.charts().get(0), 0)
                : stacked(panel.charts(), main), panel.kind());
    }

    /**
     * Makes charts above each other, over the x axis of the first. The upper one has more room; rows have a fixed
     * height.
     */
    private static XYPlot stacked(List<ChartData> data, int main) {
        Range x = data.stream().map(chart -> shown(chart, true)).reduce(null, Range::combine);
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
        return all;
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

    /** @param firstLook the number of the style of the first series without a solver */
    static XYPlot plot(ChartData given, int firstLook) {
        ChartData data = solidFirst(given);
        XYPlot plot = new XYPlot(new ChartDataset(data),
                axis(data.xLabel(), data.xLog(), shown(data, true), onlyLines(data)),
                data.rows().isEmpty() ? axis(data.yLabel(), data.yLog(), shown(data, false), false)
                        : inStyle(rowAxis(data.rows()), data.yLabel()), SeriesRenderer.of(data, firstLook));
        plot.setSeriesRenderingOrder(SeriesRenderingOrder.FORWARD);     // through dashes the line below is seen
        plot.setBackgroundPaint(Color.WHITE);
        plot.setDomainGridlinePaint(ChartStyle.GRID);
        plot.setRangeGridlinePaint(ChartStyle.GRID);
        plot.setDomainGridlineStroke(new BasicStroke(0.7f));
        plot.setRangeGridlineStroke(new BasicStroke(0.7f));
        plot.setOutlinePaint(ChartStyle.AXIS);
        plot.setAxisOffset(RectangleInsets.ZERO_INSETS);
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

    /** The range of the values that an axis shows; null if there are none, as JFreeChart expects. */
    private static Range shown(ChartData data, boolean x) {
        ChartDataset scale = new ChartDataset(data.with(data.rows(), data.scale()));
        return x ? DatasetUtils.findDomainBounds(scale) : DatasetUtils.findRangeBounds(scale);
    }

    private static boolean onlyLines(ChartData data) {
        return data.scale().stream().allMatch(series -> series.mark() == Mark.LINE || series.mark() == Mark.FAILURES);
    }

    /** Tight: from the first point to the last, without a margin, as marks need it. */
    private static ValueAxis axis(String label, boolean log, Range values, boolean tight) {
        ValueAxis axis = log ? new DecadeAxis() : new DecimalAxis();
        double margin = tight ? 0 : MARGIN;
        if (values != null) {
            axis.setRange(log ? decades(values, margin) : numbers(values, margin));
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

    /** An axis that would show less than two powers of ten is widened to whole decades. */
    private static Range decades(Range values, double margin) {
        double low = Math.log10(values.getLowerBound());
        double high = Math.log10(values.getUpperBound());
        double first = Math.floor(low + ROUNDING);
        double last = Math.ceil(high - ROUNDING);
        return last - first < 3 ? new Range(Math.pow(10, first), Math.pow(10, Math.max(last, first + 1)))
                : new Range(Math.pow(10, low - margin * (high - low)), Math.pow(10, high + margin * (high - low)));
    }

    /** An axis shows more than round-off, and without margins zero, if it is near. */
    private static Range numbers(Range values, double margin) {
        double low = values.getLowerBound();
        double high = values.getUpperBound();
        double size = Math.max(Math.abs(low), Math.abs(high));
        double least = size == 0 ? 1 : Math.max(ROUNDING * size, Double.MIN_NORMAL);
        double beside = margin * (high - low) + Math.max(0, least - (high - low)) / 2;
        return new Range(margin == 0 && low > 0 && low < NEAR_ZERO * high ? 0 : low - beside, high + beside);
    }

    /** A name for each row, the first one above. */
    private static ValueAxis rowAxis(List<String> rows) {
        SymbolAxis axis = new SymbolAxis("", rows.toArray(new String[0]));
        axis.setGridBandsVisible(false);
        axis.setInverted(true);
        axis.setRange(-0.8, rows.size() - 0.2);
        return axis;
    }
}
