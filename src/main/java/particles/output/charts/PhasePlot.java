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
                    int from = (int) (place * (series.x().length - 1));
                    if (from + 1 < series.x().length && !Double.isNaN(series.x()[from] + series.x()[from + 1])) {
                        renderer.addAnnotation(head(series, from,
                                format.on(new Color(series.look().rgb()))));
                    }
                }
            }
        }
        panel.field().ifPresent(field -> addField(plot, field, format.on(ChartStyle.FIELD)));
        return plot;
    }

    /** Adds the arrows of the field, ds/dt times a time chosen so that none is longer than its cell of the grid. */
    private static void addField(ChartPlot plot, VectorField field, Paint colour) {
        int last = field.x().length - 1;
        double cellX = field.x()[1] - field.x()[0];
        long rows = (last + 1) / Math.round(1 + (field.x()[last] - field.x()[0]) / cellX);
        double cellV = (field.v()[last] - field.v()[0]) / (rows - 1);
        double time = IntStream.range(0, field.x().length).mapToDouble(k -> Math.min(cellX / Math.abs(field.v()[k]),
                cellV / Math.abs(field.dv()[k]))).min().orElse(0);
        VectorSeries arrows = new VectorSeries("field");
        for (int k = 0; k < field.x().length; k++) {
            arrows.add(field.x()[k], field.v()[k], time * field.v()[k], time * field.dv()[k]);
        }
        VectorSeriesCollection data = new VectorSeriesCollection();
        data.addSeries(arrows);
        VectorRenderer renderer = new VectorRenderer();
        renderer.setAutoPopulateSeriesPaint(false);
        renderer.setSeriesPaint(0, colour);
        plot.setDataset(1, data);
        plot.setRenderer(1, renderer);
        show((NumberAxis) plot.getDomainAxis(), field.x()[0] - cellX / 2, field.x()[last] + cellX / 2);
        show((NumberAxis) plot.getRangeAxis(), field.v()[0] - cellV / 2, field.v()[last] + cellV / 2);
        plot.setRanges();
    }

    private static void show(NumberAxis axis, double low, double high) {
        axis.setRange(low, high);
        Axes.setTicks(axis, (high - low) / TICKS);
    }

    /** The head of an arrow at a state of a path, which points to the next one; its size is in pixels. */
    private static XYAnnotation head(Series path, int from, Paint colour) {
        XYPointerAnnotation head = new XYPointerAnnotation("", path.x()[from + 1], path.y()[from + 1], 0) {
            private static final long serialVersionUID = 1L;

            @Override
            public void draw(Graphics2D g, XYPlot plot, Rectangle2D area, ValueAxis across, ValueAxis up, int index,
                    PlotRenderingInfo info) {
                double back = across.valueToJava2D(path.x()[from], area, RectangleEdge.BOTTOM)
                        - across.valueToJava2D(getX(), area, RectangleEdge.BOTTOM);
                double down = up.valueToJava2D(path.y()[from], area, RectangleEdge.LEFT)
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
