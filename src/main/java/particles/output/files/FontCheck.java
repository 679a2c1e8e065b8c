package particles.output.files;

import java.awt.AWTError;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;

/**
 * Checks once whether this machine can draw text. A Java without fonts, or without the libraries that read them, fails
 * in many ways: InternalError, NullPointerException or UnsatisfiedLinkError at first, NoClassDefFoundError later.
 */
public final class FontCheck {
    /** The message if there is no font. */
    public static final String NO_FONT = "Java finds no font on this machine, and a chart needs text; "
            + "install one, such as the package fonts-dejavu-core (with fontconfig)";

    private FontCheck() {
    }

    /** Loaded at the first call. */
    private static final class Probe {
        static final boolean WORKS = draws();

        private static boolean draws() {
            try {
                BufferedImage image = new BufferedImage(8, 8, BufferedImage.TYPE_INT_RGB);
                Graphics2D g = image.createGraphics();
                g.setFont(font(Font.PLAIN, 12));
                int width = g.getFontMetrics().stringWidth("t = 0");
                g.drawString("t", 0, 8);
                g.dispose();
                return width > 0;
            } catch (LinkageError | InternalError | AWTError | RuntimeException e) {
                // any failure means no text; isAvailable() reports it
                return false;
            }
        }
    }

    /** @return whether text can be drawn */
    public static boolean isAvailable() {
        return Probe.WORKS;
    }

    /** @return the font of all pictures: DejaVu, or Java's substitute if it is missing */
    public static Font font(int style, float size) {
        return new Font("DejaVu Sans", style, 1).deriveFont(size);
    }
}
