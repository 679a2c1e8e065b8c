package particles.output.charts;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.Arrays;
import java.util.List;
import org.jfree.chart.ChartRenderingInfo;
import org.jfree.chart.JFreeChart;
import org.jfree.chart.ui.RectangleEdge;
import particles.view.Chart;
import particles.view.Look;
import particles.view.Panel;
import particles.view.Series;
import particles.view.Series.Mark;

/** A chart over time without a title or a legend, on which a mark moves. */
public final class StripChart {
    private static final BasicStroke NOW = new BasicStroke(1.2f);

    private final Chart data;
    private final JFreeChart chart;
    private final ChartPlot plot;

    /** Creates a chart of these data. */
    public StripChart(Chart data) {
        this.data = data;
        chart = Charts.of(Panel.of("", List.of(data)), ChartStyle.PANEL, true);
        plot = Charts.plots(chart).get(0);
        plot.ends.labelled.clear();
        plot.setRoom(plot.getRoom().getLeft(), 0);
    }

    /**
     * Draws the chart.
     *
     * @param g    the graphics to draw on
     * @param area the rectangle to fill
     * @param time the time of the marks (s)
     */
    public void draw(Graphics2D g, Rectangle2D area, double time) {
        ChartRenderingInfo drawn = new ChartRenderingInfo();
        chart.draw(g, area, drawn);
        Rectangle2D inside = drawn.getPlotInfo().getDataArea();
        double x = plot.getDomainAxis().valueToJava2D(time, inside, RectangleEdge.BOTTOM);
        g.setColor(ChartStyle.AXIS);
        g.setStroke(NOW);
        g.draw(new Line2D.Double(x, inside.getMinY(), x, inside.getMaxY()));
        for (Series series : data.series()) {
            int k = at(series, time);
            if (series.mark() != Mark.FAILURES && k >= 0 && series.y()[k] > 0) {
                double y = plot.getRangeAxis().valueToJava2D(series.y()[k], inside, RectangleEdge.LEFT);
                mark(g, series.look(), x, y);
            }
        }
    }

    private static void mark(Graphics2D g, Look look, double x, double y) {
        Shape shape = new AffineTransform(1.5, 0, 0, 1.5, x, y)
                .createTransformedShape(ChartStyle.shape(look.variant()));
        g.setColor(new Color(look.rgb()));
        g.fill(shape);
        g.setColor(Color.WHITE);
        g.setStroke(new BasicStroke(0.9f));
        g.draw(shape);
    }

    /** @return the last point at or before a time; -1 before the first and after the end of a line that ends early */
    public static int at(Series series, double time) {
        double[] t = series.x();
        return t.length == 0 || time > t[t.length - 1] * (1 + 1e-9) ? -1
                : (int) Arrays.stream(t).takeWhile(earlier -> earlier <= time * (1 + 1e-12)).count() - 1;
    }
}
