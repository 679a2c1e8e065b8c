package particles.output.charts;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Paint;
import java.awt.geom.AffineTransform;
import java.awt.geom.Rectangle2D;
import java.util.stream.IntStream;
import org.jfree.chart.annotations.XYAnnotation;
import org.jfree.chart.annotations.XYPointerAnnotation;
import org.jfree.chart.axis.NumberAxis;
import org.jfree.chart.axis.ValueAxis;
import org.jfree.chart.plot.PlotRenderingInfo;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.renderer.xy.VectorRenderer;
import org.jfree.chart.renderer.xy.XYLineAndShapeRenderer;
import org.jfree.chart.ui.RectangleEdge;
import org.jfree.data.xy.VectorSeries;
import org.jfree.data.xy.VectorSeriesCollection;
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
    private static final double HEAD = 11;
    private static final AffineTransform LARGE = AffineTransform.getScaleInstance(1.6, 1.6);
    /** The positions of arrow heads along the path's states; early ones show the first turn. */
    private static final double[] HEADS = {0.03, 0.3, 0.6};
    private static final int TICKS = 8;
    /** A path that goes no farther between two states has no direction (pixels). */
    private static final double AT_REST = 1e-3;

    private PhasePlot() {
    }

    static ChartPlot of(Panel panel, ChartFormat format) {
        ChartPlot plot = new ChartPlot(panel.charts().get(0), Panel.Kind.PHASE, TICKS, TICKS, format);
        XYLineAndShapeRenderer renderer = (XYLineAndShapeRenderer) plot.getRenderer();
        ChartDataset data = (ChartDataset) plot.getDataset();
        for (int k = 0; k < data.getSeriesCount(); k++) {
            Series series = data.series(k);
            if (series.look().rgb() == Look.MARK.rgb()) {
                renderer.setSeriesShape(k, LARGE.createTransformedShape(renderer.lookupSeriesShape(k)));
            } else if (series.mark() != Mark.FAILURES) {
                renderer.setSeriesShape(k, ChartStyle.disc(2.2));
                if (renderer.lookupSeriesStroke(k) != ChartStyle.THIN) {
                    renderer.setSeriesStroke(k, ChartStyle.stroke(0));
                }
                for (double place : HEADS) {
                    int to = 1 + (int) (place * (data.getItemCount(k) - 1));
                    if (to < data.getItemCount(k) && Double.isFinite(data.getXValue(k, to))) {
                        renderer.addAnnotation(head(data, k, to, format.on(new Color(series.look().rgb()))));
                    }
                }
            }
        }
        panel.field().ifPresent(field -> addField(plot, field, format.on(ChartStyle.FIELD)));
        return plot;
    }

    /** Adds the arrows of the field, ds/dt times a time chosen so that none is longer than its cell of the grid. */
    private static void addField(ChartPlot plot, VectorField field, Paint colour) {
        double cellX = show((NumberAxis) plot.getDomainAxis(), field.positions());
        double cellV = show((NumberAxis) plot.getRangeAxis(), field.velocities());
        plot.setRanges();
        double time = IntStream.range(0, field.dv().length).mapToDouble(k -> Math.min(cellX / Math.abs(field.v(k)),
                cellV / Math.abs(field.dv()[k]))).min().orElse(0);
        VectorSeries arrows = new VectorSeries("field");
        for (int k = 0; k < field.dv().length; k++) {
            arrows.add(field.x(k), field.v(k), time * field.v(k), time * field.dv()[k]);
        }
        VectorSeriesCollection data = new VectorSeriesCollection();
        data.addSeries(arrows);
        VectorRenderer renderer = new VectorRenderer();
        renderer.setAutoPopulateSeriesPaint(false);
        renderer.setSeriesPaint(0, colour);
        plot.setDataset(1, data);
        plot.setRenderer(1, renderer);
    }

    /** Shows the whole grid, and half a cell around it; returns the size of a cell. */
    private static double show(NumberAxis axis, double[] grid) {
        double cell = grid[1] - grid[0];
        axis.setRange(grid[0] - cell / 2, grid[grid.length - 1] + cell / 2);
        Axes.setTicks(axis, axis.getRange().getLength() / TICKS);
        return cell;
    }

    /** The head of an arrow to a state of a path from the one before; its size is in pixels. */
    private static XYAnnotation head(ChartDataset data, int k, int to, Paint colour) {
        XYPointerAnnotation head = new XYPointerAnnotation("", data.getXValue(k, to), data.getYValue(k, to), 0) {
            private static final long serialVersionUID = 1L;

            @Override
            public void draw(Graphics2D g, XYPlot plot, Rectangle2D area, ValueAxis across, ValueAxis up, int index,
                    PlotRenderingInfo info) {
                double back = across.valueToJava2D(data.getXValue(k, to - 1), area, RectangleEdge.BOTTOM)
                        - across.valueToJava2D(getX(), area, RectangleEdge.BOTTOM);
                double down = up.valueToJava2D(data.getYValue(k, to - 1), area, RectangleEdge.LEFT)
                        - up.valueToJava2D(getY(), area, RectangleEdge.LEFT);
                setAngle(Math.atan2(down, back));
                if (Math.hypot(down, back) > AT_REST) {
                    super.draw(g, plot, area, across, up, index, info);
                }
            }
        };
        head.setTipRadius(0);
        head.setBaseRadius(HEAD);
        head.setArrowLength(HEAD);
        head.setArrowWidth(0.42 * HEAD);
        head.setArrowPaint(colour);
        return head;
    }
}
