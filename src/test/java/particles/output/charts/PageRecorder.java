package particles.output.charts;

import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.GraphicsConfiguration;
import java.awt.Image;
import java.awt.Shape;
import java.awt.font.GlyphVector;
import java.awt.geom.AffineTransform;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.PathIterator;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.awt.image.ImageObserver;
import java.awt.image.RenderedImage;
import java.awt.image.renderable.RenderableImage;
import java.text.AttributedCharacterIterator;
import java.util.ArrayList;
import java.util.List;
import org.apache.batik.ext.awt.g2d.AbstractGraphics2D;
import org.apache.batik.ext.awt.g2d.GraphicContext;

/** Draws nothing, but records where a page has texts and the frames of its panels. */
public final class PageRecorder extends AbstractGraphics2D {
    private final Graphics2D measure;
    private final List<Text> texts;
    private final List<Rectangle2D> panels;
    private final List<Point2D> ends;
    private final List<Line2D> leaders;

    /**
     * A text on a page.
     *
     * @param text   what it says
     * @param box    the ink of its letters
     * @param size   the size of its type, in pixels of the layout
     * @param isTick whether it is a label of a tick
     */
    public record Text(String text, Rectangle2D box, double size, boolean isTick) {
        boolean isNumber() {
            return text.matches("[-\u2212]?[0-9.]+(e-?[0-9]+)?");
        }
    }

    /** Draws a page. */
    public PageRecorder(ChartPage page) {
        super(false);
        gc = new GraphicContext(new AffineTransform());
        measure = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB).createGraphics();
        texts = new ArrayList<>();
        panels = new ArrayList<>();
        ends = new ArrayList<>();
        leaders = new ArrayList<>();
        page.drawing().accept(this);
    }

    private PageRecorder(PageRecorder other) {
        super(other);
        measure = other.measure;
        texts = other.texts;
        panels = other.panels;
        ends = other.ends;
        leaders = other.leaders;
    }

    /** @return the texts, in the order of drawing */
    public List<Text> texts() {
        return texts;
    }

    /** @return the frames of the panels */
    public List<Rectangle2D> panels() {
        return panels;
    }

    @Override
    public void drawString(String text, float x, float y) {
        if (!text.isBlank()) {
            record(text, getFont().createGlyphVector(measure.getFontRenderContext(), text), x, y);
        }
    }

    /** JFreeChart draws the label of a vertical axis as glyphs, which do not say their text. */
    @Override
    public void drawGlyphVector(GlyphVector glyphs, float x, float y) {
        record("the label of an axis", glyphs, x, y);
    }

    private void record(String text, GlyphVector glyphs, float x, float y) {
        Rectangle2D ink = glyphs.getVisualBounds();
        ink.setRect(ink.getX() + x, ink.getY() + y, ink.getWidth(), ink.getHeight());
        texts.add(new Text(text, getTransform().createTransformedShape(ink).getBounds2D(),
                glyphs.getFont().getSize2D() * Math.sqrt(getTransform().getDeterminant()),
                glyphs.getFont().equals(ChartStyle.TICKS)));
    }

    /** @return the ends of curves, also outside of the panels */
    public List<Point2D> ends() {
        return ends;
    }

    /** @return the thin lines from ends of curves to their names */
    public List<Line2D> leaders() {
        return leaders;
    }

    @Override
    public void draw(Shape shape) {
        if (shape instanceof Path2D path && path.getCurrentPoint() != null && !isClosed(path)
                && !ChartStyle.BAR.equals(getStroke())) {             // the bar of a range is no curve
            ends.add(getTransform().transform(path.getCurrentPoint(), null));
        }
        if (shape instanceof Line2D line && ChartStyle.LEADER.equals(getStroke())) {
            leaders.add(new Line2D.Double(getTransform().transform(line.getP1(), null),
                    getTransform().transform(line.getP2(), null)));
        }
        if (shape instanceof Rectangle2D frame && ChartStyle.AXIS.equals(getPaint()) && frame.getHeight() > 1
                && frame.getWidth() > 1) {
            panels.add(getTransform().createTransformedShape(frame).getBounds2D());
        }
    }

    /** An outline of a point is closed, a curve is not. */
    private static boolean isClosed(Path2D path) {
        boolean closed = false;
        for (PathIterator part = path.getPathIterator(null); !part.isDone(); part.next()) {
            closed |= part.currentSegment(new double[6]) == PathIterator.SEG_CLOSE;
        }
        return closed;
    }

    @Override
    public Graphics create() {
        return new PageRecorder(this);
    }

    @Override
    public FontMetrics getFontMetrics(Font font) {
        return measure.getFontMetrics(font);
    }

    @Override
    public GraphicsConfiguration getDeviceConfiguration() {
        return measure.getDeviceConfiguration();
    }

    @Override
    public void drawString(AttributedCharacterIterator text, float x, float y) {
        throw new UnsupportedOperationException("no chart has text of several styles");
    }

    @Override
    public boolean drawImage(Image image, int x, int y, ImageObserver observer) {
        return true;
    }

    @Override
    public boolean drawImage(Image image, int x, int y, int width, int height, ImageObserver observer) {
        return true;
    }

    @Override
    public void fill(Shape shape) {
        // has no text
    }

    @Override
    public void drawRenderedImage(RenderedImage image, AffineTransform transform) {
        // has no text
    }

    @Override
    public void drawRenderableImage(RenderableImage image, AffineTransform transform) {
        // has no text
    }

    @Override
    public void copyArea(int x, int y, int width, int height, int dx, int dy) {
        throw new UnsupportedOperationException("no chart copies itself");
    }

    @Override
    public void setXORMode(Color colour) {
        throw new UnsupportedOperationException("no chart does");
    }

    @Override
    public void setPaintMode() {
        // always
    }

    @Override
    public void dispose() {
        // has nothing of its own
    }
}
