package particles.output.charts;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.DoubleFunction;
import java.util.function.DoublePredicate;
import org.jfree.chart.axis.ValueAxis;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.XYLineAndShapeRenderer;
import org.jfree.chart.ui.RectangleEdge;

/**
 * Labels of a chart's lines at their ends, so that nobody has to look up a colour in a legend: beside the chart for
 * lines that reach its right edge, otherwise beside the last point.
 */
final class EndLabels {
    /** A longer name is in the legend. */
    private static final int LONGEST = 34;
    /** Lines that end in this part of the chart's width, at the right, have their names beside the chart. */
    private static final double EDGE = 0.12;
    private static final double LEADER = 9;
    private static final double SAMPLE = 20;
    private static final double GAP = 5;
    /** Enough to place 14 names, which need some 100, to a hundredth of a pixel. */
    private static final int ROUNDS = 1000;
    private static final BasicStroke THIN = new BasicStroke(0.8f);
    private static final Color HALO = new Color(255, 255, 255, 215);

    private final XYPlot plot;
    private final XYLineAndShapeRenderer renderer;
    private final ChartDataset data;
    /** The series that are named. */
    final List<Integer> labelled = new ArrayList<>();

    EndLabels(XYPlot plot) {
        this.plot = plot;
        renderer = (XYLineAndShapeRenderer) plot.getRenderer();
        data = (ChartDataset) plot.getDataset();
        List<Integer> lines = new ArrayList<>();
        Set<String> names = new HashSet<>();
        for (int k = 0; k < data.getSeriesCount(); k++) {
            boolean line = renderer.getItemLineVisible(k, 0) && renderer.lookupSeriesStroke(k) != ChartStyle.BAR;
            if (line && data.last(k) >= 0 && data.name(k).length() <= LONGEST && names.add(data.name(k))) {
                lines.add(k);
            }
        }
        if (lines.size() > 1 || lines.stream().anyMatch(k -> SolverStyle.of(data.name(k)).isPresent())) {
            labelled.addAll(lines);
        }
    }

    /** @return the names that are in the chart, and need no legend */
    List<String> names() {
        return labelled.stream().map(data::name).toList();
    }

    /** @return the room that they need at the right of the chart, in pixels of the layout */
    double width(Graphics2D g) {
        FontMetrics metrics = g.getFontMetrics(ChartStyle.LABEL);
        return labelled.isEmpty() ? 0
                : LEADER + SAMPLE + 2 * GAP + names().stream().mapToInt(metrics::stringWidth).max().orElse(0);
    }

    /** @param area the rectangle of the chart's points */
    void draw(Graphics2D g, Rectangle2D area) {
        g.setFont(ChartStyle.LABEL);
        double line = g.getFontMetrics().getHeight() - 1;
        List<Shape> taken = new ArrayList<>();
        List<Integer> outside = new ArrayList<>();
        for (int k : labelled) {
            Point2D end = end(k, area);
            taken.add(new Rectangle2D.Double(end.getX() - GAP, end.getY() - GAP, 2 * GAP, 2 * GAP));
            if (end.getX() > area.getMaxX() - EDGE * area.getWidth()
                    || end.getX() + 3 * GAP + g.getFontMetrics().stringWidth(data.name(k)) > area.getMaxX()) {
                outside.add(k);
            }
        }
        outside.sort(Comparator.comparingDouble(k -> end(k, area).getY()));
        double[] wanted = outside.stream().mapToDouble(k -> end(k, area).getY()).toArray();
        double[] places = spread(wanted, line, area.getMinY() + line / 2, area.getMaxY() - line / 2);
        for (int n = 0; n < places.length; n++) {
            taken.add(drawOutside(g, outside.get(n), area, places[n]));
        }
        labelled.stream().filter(k -> !outside.contains(k)).forEach(k -> drawInside(g, k, area, line, taken));
    }

    /**
     * Draws a name beside the chart, with a thin line from the end of the series.
     *
     * @return the thin line
     */
    private Line2D drawOutside(Graphics2D g, int k, Rectangle2D area, double place) {
        double x = area.getMaxX();
        Line2D leader = new Line2D.Double(end(k, area), new Point2D.Double(x + LEADER - 1, place));
        g.setPaint(ChartStyle.FIELD);                   // a coloured one would look like more of the curve
        g.setStroke(THIN);
        g.draw(leader);
        g.setPaint(renderer.lookupSeriesFillPaint(k).equals(Color.WHITE) ? renderer.lookupSeriesPaint(k)
                : renderer.lookupSeriesFillPaint(k));
        g.setStroke(renderer.lookupSeriesStroke(k));
        g.draw(new Line2D.Double(x + LEADER, place, x + LEADER + SAMPLE, place));
        if (renderer.getItemShapeVisible(k, 0)) {
            g.fill(AffineTransform.getTranslateInstance(x + LEADER + SAMPLE / 2, place)
                    .createTransformedShape(renderer.lookupSeriesShape(k)));
        }
        g.setPaint(ChartStyle.TEXT);
        g.drawString(data.name(k), (float) (x + LEADER + SAMPLE + GAP), (float) (place + middle(g)));
        return leader;
    }

    /** Draws a name beside the end of a line, or above or below it if a name, an end or a thin line is there. */
    private void drawInside(Graphics2D g, int k, Rectangle2D area, double line, List<Shape> taken) {
        double width = g.getFontMetrics().stringWidth(data.name(k));
        Point2D end = end(k, area);
        double x = end.getX() + 2 * GAP;
        DoubleFunction<Rectangle2D> at = y -> new Rectangle2D.Double(x - 2, y - line / 2, width + 4, line);
        Rectangle2D box = at.apply(nearestFree(end.getY(), line, area.getMinY() + line / 2,
                area.getMaxY() - line / 2, y -> taken.stream().noneMatch(shape -> shape.intersects(at.apply(y)))));
        taken.add(box);
        g.setPaint(HALO);
        g.fill(box);
        g.setPaint(ChartStyle.TEXT);
        g.drawString(data.name(k), (float) x, (float) (box.getCenterY() + middle(g)));
    }

    /**
     * @param wanted the best place of the name
     * @param line   the height of a line
     * @param low    the lowest place, so that no name covers the axes
     * @param high   the highest place
     * @param isFree tells whether a place is free
     * @return the nearest free place, quarters of a line away; where all are taken, the wanted one
     */
    static double nearestFree(double wanted, double line, double low, double high, DoublePredicate isFree) {
        double end = Math.max(low, Math.min(high, wanted));
        for (double away = 0; away <= high - low; away += line / 4) {
            for (double y : new double[] {end - away, end + away}) {
                if (y >= low && y <= high && isFree.test(y)) {
                    return y;
                }
            }
        }
        return end;
    }

    /** The distance of the base line from the middle of a line of text. */
    private static double middle(Graphics2D g) {
        return (g.getFontMetrics().getAscent() - g.getFontMetrics().getDescent()) / 2.0;
    }

    /** The end of a line, or where it leaves the chart. */
    private Point2D end(int k, Rectangle2D area) {
        int last = data.last(k);
        return new Point2D.Double(inside(plot.getDomainAxis(), data.getXValue(k, last), area, RectangleEdge.BOTTOM),
                inside(plot.getRangeAxis(), data.getYValue(k, last), area, RectangleEdge.LEFT));
    }

    private static double inside(ValueAxis axis, double value, Rectangle2D area, RectangleEdge edge) {
        double shown = Math.max(axis.getLowerBound(), Math.min(axis.getUpperBound(), value));
        return axis.valueToJava2D(shown, area, edge);
    }

    /**
     * Finds places near the wanted ones that are a distance apart: neighbours that are nearer push each other away.
     *
     * @param wanted   the wanted places, in rising order
     * @param distance the distance between neighbours
     * @param low      the lowest place, unless there is no room for all
     * @param high     the highest place
     * @return the places
     */
    static double[] spread(double[] wanted, double distance, double low, double high) {
        double[] places = wanted.clone();
        for (int round = 0; round < ROUNDS; round++) {
            for (int k = 0; k < places.length; k++) {
                double push = k == 0 ? 0 : Math.max(0, distance - places[k] + places[k - 1]) / 2;
                places[Math.max(0, k - 1)] -= push;
                places[k] = Math.max(low + k * distance, Math.min(high - (places.length - 1 - k) * distance,
                        places[k] + push));
            }
        }
        return places;
    }
}
