package particles.output.charts;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Shape;
import java.awt.Stroke;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import org.jfree.chart.util.ShapeUtils;
import particles.output.files.FontCheck;

/** The common style of all charts: on white, for print and screen; lines differ in colour and dashes. */
public final class ChartStyle {
    /** The colour of text. */
    public static final Color TEXT = new Color(0x222222);
    /** The colour of axes. */
    public static final Color AXIS = new Color(0x555555);
    /** The colour of grid lines. */
    public static final Color GRID = new Color(0xdddddd);
    static final Color FIELD = new Color(0x9aa7b8);

    /** The font of a chart's title. */
    public static final Font TITLE = FontCheck.font(Font.BOLD, 15);
    /** The font of a panel's title. */
    static final Font PANEL = FontCheck.font(Font.BOLD, 13);
    /** The font of axis labels. */
    public static final Font LABEL = FontCheck.font(Font.PLAIN, 13);
    static final Font TICKS = FontCheck.font(Font.PLAIN, 12);

    /** The stroke of lines to names. */
    static final Stroke LEADER = new BasicStroke(0.8f);

    /** The stroke of lines so dense that they fill an area. */
    static final Stroke THIN = new BasicStroke(0.7f);

    /** The stroke of the spread of a measurement, and around hollow points. */
    static final Stroke BAR = new BasicStroke(1.2f);

    /** The stroke of a line that others run along. */
    static final Stroke BAND = new BasicStroke(5, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND);

    /** A sample of a line in the legend, long enough to show its dashes. */
    static final Shape LEGEND_LINE = new Line2D.Double(-17, 0, 17, 0);

    private static final List<float[]> DASHES = List.of(new float[0], new float[] {7, 3}, new float[] {2, 2.5f},
            new float[] {9, 3, 2, 3}, new float[] {14, 4}, new float[] {5, 2, 2, 2, 2, 2});
    /** The number of kinds of dashes. */
    static final int STROKES = DASHES.size();
    private static final List<Shape> SHAPES = List.of(disc(4.4), new Rectangle2D.Double(-3.3, -3.3, 6.6, 6.6),
            ShapeUtils.createUpTriangle(3.2f), ShapeUtils.createDiamond(3.7f), ShapeUtils.createDownTriangle(3.7f),
            ShapeUtils.createRegularCross(4.2f, 1.75f));

    /** The mark of a failure: a diagonal cross, larger than any mark of a result. */
    public static final Shape FAILURE = ShapeUtils.createDiagonalCross(3.9f, 1.3f);

    private ChartStyle() {
    }

    /** @return the same colour, translucent */
    static Color pale(Color colour) {
        return new Color(colour.getRed(), colour.getGreen(), colour.getBlue(), 90);
    }

    /** @return the line of a look's variant */
    public static Stroke stroke(int k) {
        float[] dashes = DASHES.get(k % DASHES.size());
        return new BasicStroke(k == 0 ? 1.6f : 1.9f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1,
                dashes.length == 0 ? null : dashes, 0);
    }

    /** @return the points of a look's variant */
    public static Shape shape(int k) {
        return SHAPES.get(k % SHAPES.size());
    }

    static Shape disc(double radius) {
        return new Ellipse2D.Double(-radius, -radius, 2 * radius, 2 * radius);
    }
}
