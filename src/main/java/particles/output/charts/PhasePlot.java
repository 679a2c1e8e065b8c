package particles.output.charts;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.AffineTransform;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.stream.IntStream;
import org.jfree.chart.annotations.AbstractXYAnnotation;
import org.jfree.chart.annotations.XYAnnotation;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.axis.ValueAxis;
import org.jfree.chart.plot.PlotRenderingInfo;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.XYLineAndShapeRenderer;
import org.jfree.chart.ui.Layer;
import org.jfree.chart.ui.RectangleEdge;
import particles.view.Look;
import particles.view.Panel;
import particles.view.Series;
import particles.view.Series.Mark;
import particles.view.VectorField;

/**
 * A phase portrait: a path in state space, in the solver's colour, with arrow heads that show its direction, marks at
 * its start and end, and the vector field behind it if it is known. The arrows of the field are proportional to its
 * strength.
 */
final class PhasePlot {
    private static final double FIELD_HEAD = 5.5;
    private static final double PATH_HEAD = 11;
    private static final AffineTransform LARGE = AffineTransform.getScaleInstance(1.6, 1.6);
    /** The positions of arrow heads along the path's states; early ones show the first turn. */
    private static final double[] HEADS = {0.03, 0.3, 0.6};
    private static final int TICKS = 8;

    private PhasePlot() {
    }

    static ChartPlot of(Panel panel) {
        ChartPlot plot = new ChartPlot(panel.charts().get(0), Panel.Kind.PHASE, TICKS, TICKS);
        XYLineAndShapeRenderer renderer = (XYLineAndShapeRenderer) plot.getRenderer();
        ChartDataset data = (ChartDataset) plot.getDataset();
        for (int k = 0; k < data.getSeriesCount(); k++) {
            Series series = data.series(k);
            if (series.look().equals(Look.MARK) || series.look().equals(Look.MARK.variant(1))) {
                renderer.setSeriesShape(k, LARGE.createTransformedShape(renderer.lookupSeriesShape(k)));
            } else if (!series.look().equals(Look.REFERENCE) && series.mark() != Mark.FAILURES) {
                renderer.setSeriesShape(k, ChartStyle.disc(2.2));
                if (renderer.lookupSeriesStroke(k) != ChartStyle.THIN) {
                    renderer.setSeriesStroke(k, ChartStyle.stroke(0));
                }
                addHeads(renderer, series, new Color(series.look().rgb()));
            }
        }
        panel.field().ifPresent(field -> addField(plot, renderer, field));
        return plot;
    }

    /** Adds the arrows of the field, ds/dt times a time chosen so that none is longer than its cell of the grid. */
    private static void addField(ChartPlot plot, XYLineAndShapeRenderer renderer, VectorField field) {
        double time = Double.POSITIVE_INFINITY;
        double cellX = spacing(field.x());
        double cellV = spacing(field.v());
        for (int k = 0; k < field.x().length; k++) {
            time = Math.min(time, Math.min(cellX / Math.abs(field.v()[k]), cellV / Math.abs(field.dv()[k])));
        }
        for (int k = 0; k < field.x().length; k++) {
            double x = field.x()[k];
            double v = field.v()[k];
            renderer.addAnnotation(arrow(
                    new Line2D.Double(x, v, x + time * field.v()[k], v + time * field.dv()[k]), FIELD_HEAD, false,
                    ChartStyle.FIELD), Layer.BACKGROUND);
        }
        show((NumberAxis) plot.getDomainAxis(), field.x(), cellX / 2);
        show((NumberAxis) plot.getRangeAxis(), field.v(), cellV / 2);
        plot.setRanges();
    }

    /** The smallest distance between two different grid lines. */
    private static double spacing(double[] values) {
        double[] sorted = Arrays.stream(values).sorted().distinct().toArray();
        return IntStream.range(1, sorted.length).mapToDouble(k -> sorted[k] - sorted[k - 1]).min()
                .orElse(Double.POSITIVE_INFINITY);
    }

    private static void show(NumberAxis axis, double[] values, double margin) {
        DoubleSummaryStatistics all = Arrays.stream(values).summaryStatistics();
        axis.setRange(all.getMin() - margin, all.getMax() + margin);
        Axes.setTicks(axis, axis.getRange().getLength() / TICKS);
    }

    private static void addHeads(XYLineAndShapeRenderer renderer, Series path, Color colour) {
        int last = path.x().length - 1;
        for (double place : HEADS) {
            int k = (int) (place * last);
            if (k < last && !Double.isNaN(path.x()[k] + path.x()[k + 1])) {
                renderer.addAnnotation(arrow(
                        new Line2D.Double(path.x()[k], path.y()[k], path.x()[k + 1], path.y()[k + 1]), PATH_HEAD, true,
                        colour), Layer.FOREGROUND);
            }
        }
    }

    /**
     * An arrow between two points of a chart; the size of its head is in pixels, independent of the axes.
     *
     * @param line     from its tail to its tip, in the values of the axes
     * @param head     the length of the head (logical pixels); a shorter arrow has a smaller one
     * @param headOnly whether only the head is drawn, in full size, its tip at the second point
     */
    private static XYAnnotation arrow(Line2D.Double line, double head, boolean headOnly, Color colour) {
        return new AbstractXYAnnotation() {
            private static final long serialVersionUID = 1L;

            @Override
            public void draw(Graphics2D g, XYPlot plot, Rectangle2D area, ValueAxis domain, ValueAxis range,
                    int rendererIndex, PlotRenderingInfo info) {
                RectangleEdge below = plot.getDomainAxisEdge();
                RectangleEdge beside = plot.getRangeAxisEdge();
                double x0 = domain.valueToJava2D(line.x1, area, below);
                double y0 = range.valueToJava2D(line.y1, area, beside);
                double x1 = domain.valueToJava2D(line.x2, area, below);
                double y1 = range.valueToJava2D(line.y2, area, beside);
                double length = Math.hypot(x1 - x0, y1 - y0);
                if (!(length > 1e-3) || !(length <= 1e6)) {
                    return;
                }
                double size = headOnly ? head : Math.min(head, 0.6 * length);
                double width = 0.42 * size;
                // drawn along the x axis with its tip at 0, and turned
                AffineTransform turned = AffineTransform.getTranslateInstance(x1, y1);
                turned.rotate(x1 - x0, y1 - y0);
                g.setPaint(colour);
                if (!headOnly) {
                    g.setStroke(new BasicStroke(1));
                    g.draw(turned.createTransformedShape(new Line2D.Double(-length, 0, -0.8 * size, 0)));
                }
                Path2D tip = new Path2D.Double();
                tip.moveTo(0, 0);
                tip.lineTo(-size, -width);
                tip.lineTo(-size, width);
                tip.closePath();
                g.fill(turned.createTransformedShape(tip));
            }
        };
    }
}
