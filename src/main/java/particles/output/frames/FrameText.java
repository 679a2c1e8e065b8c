package particles.output.frames;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Locale;
import particles.output.raster.Colours;
import particles.output.raster.Sky;
import particles.output.text.DecimalTicks;
import particles.output.text.FontCheck;

/**
 * The words of a picture: the scene's title, time and solver, and the scale of strain. Without a font there are none.
 */
final class FrameText {
    private final FrameSetup stage;
    private final Sky sky;
    private final float unit;
    private final int decimals;

    /** @param decimals of the time (s), as many as tell one frame from the next */
    FrameText(FrameSetup stage, int height, int decimals) {
        this.stage = stage;
        this.sky = Sky.of(stage.look().style().night());
        this.unit = Math.max(0.5f, height / 720f);
        this.decimals = decimals;
    }

    void draw(Graphics2D g, int width, int height, double time, boolean withStrain) {
        if (!FontCheck.isAvailable()) {
            return;
        }
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        float margin = 26 * unit;
        g.setColor(sky.ink);
        g.setFont(FontCheck.font(Font.BOLD, 24 * unit));
        g.drawString(stage.title(), margin, margin + 17 * unit);
        g.setFont(FontCheck.font(Font.PLAIN, 24 * unit));
        g.drawString(String.format(Locale.ROOT, "t = %." + decimals + "f s", time), margin,
                height - margin - 29 * unit);
        g.setColor(sky.soft);
        g.setFont(FontCheck.font(Font.PLAIN, 18 * unit));
        g.drawString(stage.caption(), margin, height - margin);
        if (withStrain) {
            drawScale(g, width - margin, height - margin);
        }
    }

    /** A bar from compressed to stretched, with its ends in per cent. */
    private void drawScale(Graphics2D g, float right, float bottom) {
        double range = stage.look().strainRange();
        String percent = DecimalTicks.label(new BigDecimal(100 * range).round(new MathContext(3)));
        int length = Math.round(220 * unit);
        int thickness = Math.round(11 * unit);
        int x = Math.round(right) - length;
        int y = Math.round(bottom - 25 * unit) - thickness;
        for (int k = 0; k < length; k++) {
            g.setColor(new Color(Colours.ofStrain((2.0 * (k + 0.5) / length - 1) * range, range)));
            g.fillRect(x + k, y, 1, thickness);
        }
        g.setFont(FontCheck.font(Font.PLAIN, 16 * unit));
        g.setColor(sky.soft);
        float line = bottom;
        g.drawString("\u2212" + percent + " %", x, line);
        centred(g, "strain", x + length / 2f, line);
        String most = "+" + percent + " %";
        g.drawString(most, right - g.getFontMetrics().stringWidth(most), line);
    }

    private static void centred(Graphics2D g, String text, float x, float y) {
        g.drawString(text, x - g.getFontMetrics().stringWidth(text) / 2f, y);
    }
}
