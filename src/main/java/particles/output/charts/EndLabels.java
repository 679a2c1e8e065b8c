package particles.output.charts;

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

    private final XYPlot plot;
    private final XYLineAndShapeRenderer renderer;
    private final ChartDataset data;
    private final ChartFormat format;
    /** The series that are named. */
    final List<Integer> labelled = new ArrayList<>();

    /**
     * @param named  whether lines are named here, and not in the legend
     * @param format the format of the picture
     */
    EndLabels(XYPlot plot, boolean named, ChartFormat format) {
        this.plot = plot;
        this.format = format;
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
        List<Integer> sorted = labelled.stream().sorted(Comparator.comparing(k -> end(k, area).getY())).toList();
        double[] places = spread(sorted.stream().mapToDouble(k -> end(k, area).getY()).toArray(), LINE,
                area.getMinY() + LINE / 2, area.getMaxY() - LINE / 2);
        for (int n = 0; n < places.length; n++) {
            draw(g, sorted.get(n), area, places[n]);
        }
    }

    /** The place of a line's last point, or where the line leaves the chart. */
    private Point2D end(int k, Rectangle2D area) {
        ValueAxis x = plot.getDomainAxis();
        ValueAxis y = plot.getRangeAxis();
        return new Point2D.Double(
                x.valueToJava2D(x.getRange().constrain(data.getXValue(k, data.last(k))), area, RectangleEdge.BOTTOM),
                y.valueToJava2D(y.getRange().constrain(data.getYValue(k, data.last(k))), area, RectangleEdge.LEFT));
    }

    /** Draws a name after a sample of its line. From far away, thin lines would cross others. */
    private void draw(Graphics2D g, int k, Rectangle2D area, double place) {
        double x = area.getMaxX() + LEADER;
        Point2D end = end(k, area);
        if (end.getX() > area.getMaxX() - EDGE * area.getWidth()) {
            g.setPaint(format.on(ChartStyle.FIELD));               // a coloured one would look like more of the curve
            g.setStroke(ChartStyle.LEADER);
            g.draw(new Line2D.Double(end, new Point2D.Double(x - 1, place)));
        }
        g.setPaint(renderer.lookupSeriesPaint(k));
        g.setStroke(renderer.lookupSeriesStroke(k));
        g.draw(new Line2D.Double(x, place, x + SAMPLE, place));
        if (renderer.getItemShapeVisible(k, 0)) {
            g.fill(AffineTransform.getTranslateInstance(x + SAMPLE / 2, place)
                    .createTransformedShape(renderer.lookupSeriesShape(k)));
        }
        g.setPaint(format.on(ChartStyle.TEXT));
        g.setFont(ChartStyle.LABEL);
        g.drawString(text(k), (float) (x + SAMPLE + GAP), (float) (place + LINE / 3));
    }

    /** @return places near the wanted ones, which rise, at least a distance apart and from low to high if possible */
    static double[] spread(double[] wanted, double distance, double low, double high) {
        double[] places = wanted.clone();
        for (int round = 0; round < ROUNDS; round++) {
            for (int k = 0; k < places.length; k++) {   // neighbours that are too near push each other away
                double push = k == 0 ? 0 : Math.max(0, distance - places[k] + places[k - 1]) / 2;
                places[Math.max(0, k - 1)] -= push;
                places[k] = Math.max(low + k * distance, Math.min(high - (places.length - 1 - k) * distance,
                        places[k] + push));
            }
        }
        return places;
    }
}
