package particles.output.charts;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.AffineTransform;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import org.jfree.chart.annotations.AbstractXYAnnotation;
import org.jfree.chart.axis.ValueAxis;
import org.jfree.chart.plot.PlotRenderingInfo;
import org.jfree.chart.plot.XYPlot;
import org.jfree.chart.ui.RectangleEdge;

/** An arrow between two points of a chart; the size of its head is in pixels, independent of the axes. */
final class ArrowAnnotation extends AbstractXYAnnotation {
    private static final long serialVersionUID = 1L;

    private final Line2D.Double line;
    private final double head;
    private final boolean headOnly;
    private final Color colour;

    /**
     * @param line     from its tail to its tip, in the values of the axes
     * @param head     the length of the head (logical pixels); a shorter arrow has a smaller one
     * @param headOnly whether only the head is drawn, in full size, its tip at the second point
     */
    ArrowAnnotation(Line2D.Double line, double head, boolean headOnly, Color colour) {
        this.line = line;
        this.head = head;
        this.headOnly = headOnly;
        this.colour = colour;
    }

    @Override
    public void draw(Graphics2D g, XYPlot plot, Rectangle2D area, ValueAxis domain, ValueAxis range, int rendererIndex,
                     PlotRenderingInfo info) {
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
}
