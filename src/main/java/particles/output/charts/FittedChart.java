package particles.output.charts;

import deSolvers.text.Digits;
import java.awt.Graphics2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jfree.chart.ChartRenderingInfo;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.axis.NumberTickUnit;
import org.jfree.chart.axis.ValueAxis;
import org.jfree.chart.plot.CombinedDomainXYPlot;
import org.jfree.chart.plot.PlotRenderingInfo;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.title.TextTitle;
import org.jfree.chart.ui.HorizontalAlignment;
import org.jfree.chart.ui.RectangleEdge;
import org.jfree.chart.ui.RectangleInsets;
import org.jfree.data.Range;

/** A chart that fits itself to the page when it is drawn: room for the names of its lines, and round circles. */
final class FittedChart extends JFreeChart {
    private static final long serialVersionUID = 1L;
    /**
     * With equal units an axis shows at most this many times its range; beyond that the chart gets narrower or lower.
     */
    private static final double WIDENED = 1.12;
    /** Axes whose ranges differ by less than this factor have equal units. */
    private static final double ALIKE = 1.34;
    private static final int TRIALS = 4;
    /** The part of the width for a line of the title; JFreeChart measures otherwise, and breaks none of these again. */
    private static final double NARROWER = 0.95;

    private final String title;
    private final transient List<EndLabels> labels = new ArrayList<>();
    private final boolean map;
    private final boolean equalUnits;
    private final boolean tellsUnits;
    private final transient Range x;
    private final transient Range y;
    private final TextTitle units = new TextTitle("", ChartStyle.TICKS);

    /**
     * @param title the title of the chart
     * @param plot  one plot, or several above each other
     * @param kind  a map always has equal units, and a path in state space where its axes show about the same range
     */
    FittedChart(String title, XYPlot plot, Panel.Kind kind) {
        super(title, ChartStyle.TITLE, plot, false);
        this.title = title;
        boolean combined = plot instanceof CombinedDomainXYPlot;
        x = plot.getDomainAxis().getRange();
        y = combined ? x : plot.getRangeAxis().getRange();
        if (kind == Panel.Kind.CHART) {
            subplots(plot).forEach(part -> labels.add(new EndLabels(part)));
        }
        map = kind == Panel.Kind.MAP;
        equalUnits = !combined && (map || kind == Panel.Kind.PHASE
                && areAlike(x, y));
        tellsUnits = kind == Panel.Kind.PHASE && !equalUnits;
        if (tellsUnits) {
            units.setPosition(RectangleEdge.BOTTOM);
            units.setHorizontalAlignment(HorizontalAlignment.RIGHT);
            units.setPaint(ChartStyle.AXIS);
            addSubtitle(units);
        }
    }

    static List<XYPlot> subplots(XYPlot plot) {
        return plot instanceof CombinedDomainXYPlot all ? List.copyOf(all.getSubplots()) : List.of(plot);
    }

    static boolean areAlike(Range x, Range y) {
        return x.getLength() < ALIKE * y.getLength() && y.getLength() < ALIKE * x.getLength();
    }

    /** @return whether a unit along x is as long as one along y */
    boolean hasEqualUnits() {
        return equalUnits;
    }

    /** Puts the legend beside the points: on a wide page, below them it would make a round chart small. */
    void setLegendBeside() {
        Optional.ofNullable(getLegend()).ifPresent(legend -> legend.setPosition(RectangleEdge.RIGHT));
    }

    /** @return the names at the ends of lines */
    List<String> labelledNames() {
        return labels.stream().flatMap(part -> part.names().stream()).toList();
    }

    /** Removes the names, if something else names the lines. */
    void removeLabels() {
        labels.clear();
    }

    @Override
    public void draw(Graphics2D g, Rectangle2D area, Point2D anchor, ChartRenderingInfo info) {
        ChartRenderingInfo seen = info == null ? new ChartRenderingInfo() : info;
        breakTitle(g, NARROWER * (area.getWidth() - getPadding().getLeft() - getPadding().getRight()));
        if (equalUnits || tellsUnits) {
            fitUnits(area);
        } else {
            RectangleInsets least = XYPlot.DEFAULT_INSETS;
            double room = labels.stream().mapToDouble(part -> part.width(g)).max().orElse(0);
            getXYPlot().setInsets(new RectangleInsets(least.getTop(), least.getLeft(), least.getBottom(),
                    least.getRight() + room));
        }
        super.draw(g, area, anchor, seen);
        for (int k = 0; k < labels.size(); k++) {
            labels.get(k).draw(g, frame(seen, k));
        }
    }

    /**
     * Draws the chart.
     *
     * @return the frame of the points, or of those of the uppermost chart
     */
    Rectangle2D frame(Graphics2D g, Rectangle2D area) {
        ChartRenderingInfo info = new ChartRenderingInfo();
        draw(g, area, null, info);
        return frame(info, 0);
    }

    /** The frame of the k-th of several charts above each other, or of the only one. */
    private static Rectangle2D frame(ChartRenderingInfo drawn, int k) {
        PlotRenderingInfo plots = drawn.getPlotInfo();
        return (plots.getSubplotCount() > k ? plots.getSubplotInfo(k) : plots).getDataArea();
    }

    /** Breaks the title at spaces; JFreeChart would break it within a number, too. */
    private void breakTitle(Graphics2D g, double width) {
        if (getTitle() != null) {
            getTitle().setText(String.join("\n", ChartStyle.wrapped(title,
                    g.getFontMetrics(getTitle().getFont()), width)));
        }
    }

    /** Fits equal units by trial: the room of axes depends on their labels, and these on the room. */
    private void fitUnits(Rectangle2D area) {
        XYPlot plot = getXYPlot();
        plot.setInsets(XYPlot.DEFAULT_INSETS);
        if (tellsUnits) {
            units.setText(" ");                         // as high as the text that will stand there
        }
        plot.getDomainAxis().setAutoTickUnitSelection(true);
        plot.getRangeAxis().setAutoTickUnitSelection(true);
        for (int trial = 0; trial < TRIALS; trial++) {
            Rectangle2D inside = trial(area);
            if (tellsUnits) {
                double metres = x.getLength() / inside.getWidth();
                double speeds = y.getLength() / inside.getHeight();
                units.setText("1 " + unit(plot.getDomainAxis()) + " is drawn as long as "
                        + Digits.few(speeds / metres, 2) + " " + unit(plot.getRangeAxis()));
                return;
            }
            if (trial == 0) {
                double unit = Math.min(inside.getWidth() / x.getLength(), inside.getHeight() / y.getLength());
                plot.getDomainAxis().setRange(widened(x, inside.getWidth() / unit));
                plot.getRangeAxis().setRange(widened(y, inside.getHeight() / unit));
            }
            double across = plot.getDomainAxis().getRange().getLength();
            double up = plot.getRangeAxis().getRange().getLength();
            double unit = Math.min(inside.getWidth() / across, inside.getHeight() / up);
            RectangleInsets insets = plot.getInsets();
            double beside = insets.getLeft() + (inside.getWidth() - unit * across) / 2;
            double above = insets.getTop() + (inside.getHeight() - unit * up) / 2;
            plot.setInsets(new RectangleInsets(above, beside, above, beside));
            if (trial == 1) {
                shareTicks((NumberAxis) plot.getDomainAxis(), (NumberAxis) plot.getRangeAxis());
            }
        }
    }

    /** Where units are equally long, both axes have the same ticks. */
    private static void shareTicks(NumberAxis across, NumberAxis up) {
        NumberTickUnit larger = across.getTickUnit().getSize() > up.getTickUnit().getSize() ? across.getTickUnit()
                : up.getTickUnit();
        across.setTickUnit(larger);
        up.setTickUnit(larger);
    }

    /** The unit stands in brackets at the end of an axis' label. */
    private static String unit(ValueAxis axis) {
        return axis.getLabel().replaceFirst(".*\\((.*)\\)$", "$1");
    }

    /** @return the rectangle that the points would have */
    private Rectangle2D trial(Rectangle2D area) {
        Graphics2D page = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB).createGraphics();
        ChartRenderingInfo info = new ChartRenderingInfo();
        super.draw(page, area, null, info);
        page.dispose();
        return info.getPlotInfo().getDataArea();
    }

    /** A map ends where it was computed. */
    private Range widened(Range range, double length) {
        double half = Math.min(length, (map ? 1 : WIDENED) * range.getLength()) / 2;
        return new Range(range.getCentralValue() - half, range.getCentralValue() + half);
    }
}
