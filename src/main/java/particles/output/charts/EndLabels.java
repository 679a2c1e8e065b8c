package particles.output.charts;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.AffineTransform;
import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.jfree.chart.axis.ValueAxis;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.XYLineAndShapeRenderer;
import org.jfree.chart.ui.RectangleEdge;
import particles.view.Series;

/**
 * Names of a chart's lines with their numbers, so that nobody has to look up a colour in a legend: beside the chart,
 * where they cover nothing, at the height of the end of their line.
 */
final class EndLabels {
    /** A thin line leads to the name of a line that ends in this part of the chart's width, at the right. */
    private static final double EDGE = 0.12;
    private static final double LEADER = 9;
    private static final double SAMPLE = 20;
    private static final double GAP = 5;
    private static final double LINE = 15;
    /** Enough to place 14 names, which need some 100, to a hundredth of a pixel. */
    private static final int ROUNDS = 1000;
    private static final BasicStroke THIN = new BasicStroke(0.8f);

    private final XYPlot plot;
    private final XYLineAndShapeRenderer renderer;
    private final ChartDataset data;
    /** The series that are named. */
    final List<Integer> labelled = new ArrayList<>();

    /** @param named whether lines are named here, and not in the legend */
    EndLabels(XYPlot plot, boolean named) {
        this.plot = plot;
        renderer = (XYLineAndShapeRenderer) plot.getRenderer();
        data = (ChartDataset) plot.getDataset();
        for (int k = 0; named && k < data.getSeriesCount(); k++) {
            if (data.series(k).mark().isCurve() && data.last(k) >= 0) {
                labelled.add(k);
            }
        }
    }

    private String text(int k) {
        Series series = data.series(k);
        return (series.name() + "  " + series.end()).strip();
    }

    /** @return the room that they need at the right of the chart, in pixels of the layout */
    double width() {
        return labelled.stream().mapToDouble(k -> LEADER + SAMPLE + 2 * GAP + Axes.width(ChartStyle.LABEL, text(k)))
                .max().orElse(0);
    }

    /** @param area the rectangle of the chart's points */
    void draw(Graphics2D g, Rectangle2D area) {
        List<Integer> sorted = labelled.stream().sorted(Comparator.comparingDouble(k -> end(k, area).getY())).toList();
        double[] wanted = sorted.stream().mapToDouble(k -> end(k, area).getY()).toArray();
        double[] places = spread(wanted, LINE, area.getMinY() + LINE / 2, area.getMaxY() - LINE / 2);
        for (int n = 0; n < places.length; n++) {
            draw(g, sorted.get(n), area, places[n]);
        }
    }

    /** Draws a name after a sample of its line. From far away, thin lines would cross others. */
    private void draw(Graphics2D g, int k, Rectangle2D area, double place) {
        double x = area.getMaxX() + LEADER;
        Point2D end = end(k, area);
        if (end.getX() > area.getMaxX() - EDGE * area.getWidth()) {
            g.setPaint(ChartStyle.FIELD);               // a coloured one would look like more of the curve
            g.setStroke(THIN);
            g.draw(new Line2D.Double(end, new Point2D.Double(x - 1, place)));
        }
        g.setPaint(renderer.lookupSeriesFillPaint(k).equals(Color.WHITE) ? renderer.lookupSeriesPaint(k)
                : renderer.lookupSeriesFillPaint(k));
        g.setStroke(renderer.lookupSeriesStroke(k));
        g.draw(new Line2D.Double(x, place, x + SAMPLE, place));
        if (renderer.getItemShapeVisible(k, 0)) {
            g.fill(AffineTransform.getTranslateInstance(x + SAMPLE / 2, place)
                    .createTransformedShape(renderer.lookupSeriesShape(k)));
        }
        g.setPaint(ChartStyle.TEXT);
        g.setFont(ChartStyle.LABEL);
        double middle = (g.getFontMetrics().getAscent() - g.getFontMetrics().getDescent()) / 2.0;
        g.drawString(text(k), (float) (x + SAMPLE + GAP), (float) (place + middle));
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
