package particles.output.frames;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.font.FontRenderContext;
import java.awt.geom.Rectangle2D;

/** A line of text in a picture: its left end, and its baseline from the top (pixels). */
record TextLine(String text, Font font, Color colour, double x, double y) {
    private static final FontRenderContext SMOOTH = new FontRenderContext(null, true, true);

    static void smooth(Graphics2D g) {
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    }

    static double width(String text, Font font) {
        return font.getStringBounds(text, SMOOTH).getWidth();
    }

    /** @return the rectangle that it takes up (pixels) */
    Rectangle2D box() {
        Rectangle2D box = font.getStringBounds(text, SMOOTH);
        return new Rectangle2D.Double(x, y + box.getY(), box.getWidth(), box.getHeight());
    }

    void draw(Graphics2D g) {
        g.setColor(colour);
        g.setFont(font);
        g.drawString(text, (float) x, (float) y);
    }
}
