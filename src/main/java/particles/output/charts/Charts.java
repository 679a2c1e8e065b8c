package particles.output.charts;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.List;
import org.jfree.chart.ChartRenderingInfo;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.axis.LogAxis;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.axis.NumberTickUnitSource;
import org.jfree.chart.axis.SymbolAxis;
import org.jfree.chart.axis.ValueAxis;
import org.jfree.chart.plot.CombinedDomainXYPlot;
import org.jfree.chart.plot.SeriesRenderingOrder;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.XYLineAndShapeRenderer;
import org.jfree.chart.title.TextTitle;
import org.jfree.chart.ui.RectangleInsets;
import org.jfree.data.Range;
import org.jfree.data.general.DatasetUtils;
import particles.view.ChartData;
import particles.view.ChartData.Mark;

/** Chart data as JFreeChart's charts, in the common style. */
public final class Charts {
    /** Values that differ by less than this part of their size differ by rounding, which needs no axis of its own. */
    private static final double ROUNDING = 1e-13;

    /**
     * Lines that go up and down by their range more often than this fill an area; they then let others shine through.
     */
    private static final int DENSE = 120;

    /** The height of a row, in pixels as the other charts' heights, roughly. */
    static final int ROW = 17;

    private Charts() {
    }

    public static JFreeChart of(ChartData data) {
        return finished(data.title(), plot(data));
    }

    /** Charts above each other, over the x axis of the first; the upper one has more room, rows have what they need. */
    static JFreeChart stacked(List<ChartData> data) {
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
                    : ofQuantities > 1 ? 255 : 400);
            looks += series;
        }
        return finished(data.get(0).title(), all);
    }

    /** With the same unit along both axes: the one that would have the longer unit shows more. */
    static JFreeChart map(ChartData data, int width, int height) {
        JFreeChart chart = of(data);
        ChartRenderingInfo info = new ChartRenderingInfo();
        Graphics2D trial = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB).createGraphics();
        chart.draw(trial, new Rectangle2D.Double(0, 0, width, height), info);
        trial.dispose();
        Rectangle2D area = info.getPlotInfo().getDataArea();
        Range x = chart.getXYPlot().getDomainAxis().getRange();
        Range y = chart.getXYPlot().getRangeAxis().getRange();
        double unit = Math.min(area.getWidth() / x.getLength(), area.getHeight() / y.getLength());
        chart.getXYPlot().getDomainAxis().setRange(widened(x, area.getWidth() / unit));
        chart.getXYPlot().getRangeAxis().setRange(widened(y, area.getHeight() / unit));
        return chart;
    }

    private static Range widened(Range range, double length) {
        double middle = range.getCentralValue();
        return new Range(middle - length / 2, middle + length / 2);
    }

    private static JFreeChart finished(String title, XYPlot plot) {
        JFreeChart chart = new JFreeChart(title, ChartStyle.TITLE, plot, false);
        chart.setBackgroundPaint(Color.WHITE);
        chart.setPadding(new RectangleInsets(8, 8, 8, 14));
        TextTitle heading = chart.getTitle();
        heading.setPaint(ChartStyle.TEXT);
        heading.setMargin(2, 0, 6, 0);
        ChartLegend.addTo(chart, plot);
        return chart;
    }

    static XYPlot plot(ChartData data) {
        return plot(data, 0);
    }

    private static XYPlot plot(ChartData data, int firstLook) {
        ChartDataset dataset = new ChartDataset(data);
        XYPlot plot = new XYPlot(dataset, axis(data.xLabel(), data.xLog(), range(dataset, true), onlyLines(data)),
                data.rows().isEmpty() ? axis(data.yLabel(), data.yLog(), range(dataset, false), false)
                        : inStyle(rowAxis(data.rows()), data.yLabel()), renderer(data, firstLook));
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

    /** Null where there is no point at all, as JFreeChart says it. */
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
        LogAxis axis = new LogAxis();
        axis.setBaseSymbol("10");
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

    private static XYLineAndShapeRenderer renderer(ChartData data, int firstLook) {
        XYLineAndShapeRenderer renderer = new XYLineAndShapeRenderer();
        renderer.setDrawSeriesLineAsPath(true);         // dashes run on from point to point
        renderer.setUseOutlinePaint(true);
        renderer.setUseFillPaint(true);
        boolean ofSolvers = data.series().stream().anyMatch(series -> SolverStyle.of(series.name()).isPresent());
        for (int k = 0; k < data.series().size(); k++) {
            Mark mark = data.series().get(k).mark();
            boolean dense = mark == Mark.LINE && k > 0 && isDense(data.series().get(k).y());
            SolverStyle look = SolverStyle.of(data.series().get(k).name()).orElse(new SolverStyle(
                    ofSolvers ? ChartStyle.AXIS : ChartStyle.colour(firstLook + k), ChartStyle.stroke(firstLook + k),
                    ChartStyle.shape(firstLook + k)));
            boolean failed = mark == Mark.FAILURES || mark == Mark.GIVEN_UP;
            boolean open = mark == Mark.LINE_AND_OPEN_POINTS || mark == Mark.OPEN_POINTS;
            Color colour = failed ? Color.RED.darker() : look.colour();
            renderer.setSeriesLinesVisible(k, !failed && mark != Mark.POINTS && mark != Mark.OPEN_POINTS);
            renderer.setSeriesShapesVisible(k, mark != Mark.LINE && mark != Mark.BARS && mark != Mark.BAND);
            renderer.setSeriesPaint(k, dense || mark == Mark.BAND ? ChartStyle.pale(colour) : colour);
            renderer.setSeriesStroke(k, dense ? ChartStyle.THIN : mark == Mark.BARS ? ChartStyle.BAR
                    : mark == Mark.BAND ? ChartStyle.BAND : look.stroke());
            renderer.setSeriesShape(k, mark == Mark.FAILURES ? ChartStyle.FAILURE
                    : mark == Mark.GIVEN_UP ? ChartStyle.GIVEN_UP : look.shape());
            renderer.setSeriesFillPaint(k, open ? Color.WHITE : colour);
            renderer.setSeriesOutlinePaint(k, open ? colour : Color.WHITE);
            renderer.setSeriesOutlineStroke(k, open ? ChartStyle.BAR : new BasicStroke(0.6f));
        }
        return renderer;
    }

    /** Whether a line goes to and fro so often that it covers what lies below, unless it lets that shine through. */
    static boolean isDense(double[] y) {
        double low = Double.POSITIVE_INFINITY;
        double high = Double.NEGATIVE_INFINITY;
        double way = 0;
        for (int k = 0; k < y.length; k++) {
            low = Math.min(low, y[k]);
            high = Math.max(high, y[k]);
            way += Math.abs(y[k] - y[Math.max(0, k - 1)]);
        }
        return way > DENSE * (high - low);
    }
}
