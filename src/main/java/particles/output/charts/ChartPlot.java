package particles.output.charts;

import java.awt.Graphics2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.Arrays;
import java.util.Comparator;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import org.jfree.chart.axis.AxisSpace;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.plot.PlotRenderingInfo;
import org.jfree.chart.plot.PlotState;
import org.jfree.chart.plot.SeriesRenderingOrder;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.ui.RectangleInsets;
import org.jfree.data.Range;
import org.jfree.data.general.DatasetUtils;
import particles.view.Chart;
import particles.view.Panel;
import particles.view.Series;
import particles.view.Series.Mark;

/** The plot of a chart: it keeps circles round, and draws names at the ends of lines. */
final class ChartPlot extends XYPlot {
    private static final long serialVersionUID = 1L;
    /** Axes whose ranges differ by less than this factor have equal units. */
    private static final double ALIKE = 1.34;

    final transient EndLabels ends;
    /** The room at the left, for the axis, and at the right, for the names of lines. */
    final AxisSpace beside = new AxisSpace();
    /** Whether a unit along x is as long as one along y. */
    boolean round;
    private final Panel.Kind kind;

    /**
     * @param ticks  the largest number of ticks along x
     * @param high   the largest number of ticks along y
     * @param format the format of the picture
     */
    ChartPlot(Chart chart, Panel.Kind kind, int ticks, int high, ChartFormat format) {
        this.kind = kind;
        List<Series> layers = chart.series().stream().sorted(Comparator.comparing(ChartPlot::layer)).toList();
        ChartDataset dataset = new ChartDataset(chart, layers);
        setDataset(dataset);
        setDomainAxis(Axes.of(chart.x(), shown(chart, true), kind == Panel.Kind.MAP || onlyLines(chart), ticks));
        setRangeAxis(chart.rows().isEmpty() ? Axes.of(chart.y(), shown(chart, false), kind == Panel.Kind.MAP, high)
                : Axes.rows(chart.y().label(), chart.rows()));
        setRenderer(SeriesRenderer.of(layers, kind == Panel.Kind.PHASE, format));
        setSeriesRenderingOrder(SeriesRenderingOrder.FORWARD);
        setDomainGridlineStroke(ChartStyle.THIN);
        setRangeGridlineStroke(ChartStyle.THIN);
        setInsets(RectangleInsets.ZERO_INSETS);
        setFixedDomainAxisSpace(Axes.below());
        ends = new EndLabels(this, kind == Panel.Kind.CHART, format);
        setRoom(Axes.left(getRangeAxis()), ends.width());
        setRanges();
    }

    /** Through dashes the line below is seen; marks are on top. */
    private static int layer(Series series) {
        return series.mark().isWide() ? 0 : !series.mark().isCurve() ? 3 : series.look().variant() == 0 ? 1 : 2;
    }

    /**
     * The range of the values that an axis shows, along x also of points without a value along y; null if there are
     * none, as JFreeChart expects.
     */
    static Range shown(Chart chart, boolean x) {
        if (!x) {
            return DatasetUtils.findRangeBounds(new ChartDataset(chart, chart.scale()));
        }
        DoubleSummaryStatistics range = chart.scale().stream().flatMapToDouble(one -> Arrays.stream(one.x()))
                .filter(value -> ChartDataset.isDrawn(chart.x(), value)).summaryStatistics();
        return range.getCount() == 0 ? null : new Range(range.getMin(), range.getMax());
    }

    static boolean onlyLines(Chart chart) {
        return chart.scale().stream().allMatch(series -> series.mark() == Mark.LINE || series.mark() == Mark.FAILURES);
    }

    /** Takes the ranges of the axes for those that are to be shown. */
    void setRanges() {
        Range x = getDomainAxis().getRange();
        Range y = getRangeAxis().getRange();
        round = kind == Panel.Kind.MAP || kind == Panel.Kind.PHASE && areAlike(x, y);
        if (round) {                                    // where units are equally long, both axes have the same ticks
            double least = Math.max(x.getLength(), y.getLength()) / 7;
            Axes.setTicks((NumberAxis) getDomainAxis(), least);
            Axes.setTicks((NumberAxis) getRangeAxis(), least);
        }
    }

    static boolean areAlike(Range x, Range y) {
        return x.getLength() < ALIKE * y.getLength() && y.getLength() < ALIKE * x.getLength();
    }

    /** Sets the room at the left, for the axis, and at the right, for the names of lines. */
    void setRoom(double left, double right) {
        beside.setLeft(left);
        beside.setRight(right);
        setFixedRangeAxisSpace(beside);
    }

    /** Charts above each other forget their fixed room before they take the largest of all. */
    @Override
    protected AxisSpace calculateRangeAxisSpace(Graphics2D g, Rectangle2D area, AxisSpace space) {
        return getFixedRangeAxisSpace() == null ? beside : super.calculateRangeAxisSpace(g, area, space);
    }

    @Override
    public void draw(Graphics2D g, Rectangle2D area, Point2D anchor, PlotState state, PlotRenderingInfo info) {
        super.draw(g, round ? rounded(area) : area, anchor, state, info);
    }

    /** The part of the area in which circles are round. */
    private Rectangle2D rounded(Rectangle2D area) {
        double across = getDomainAxis().getRange().getLength();
        double up = getRangeAxis().getRange().getLength();
        double width = area.getWidth() - beside.getLeft() - beside.getRight();
        double height = area.getHeight() - getFixedDomainAxisSpace().getBottom();
        double pixels = Math.min(width / across, height / up);
        double dx = width - pixels * across;
        double dy = height - pixels * up;
        return new Rectangle2D.Double(area.getX() + dx / 2, area.getY() + dy / 2, area.getWidth() - dx,
                area.getHeight() - dy);
    }

    @Override
    public void drawOutline(Graphics2D g, Rectangle2D area) {
        super.drawOutline(g, area);
        ends.draw(g, area);
    }
}
