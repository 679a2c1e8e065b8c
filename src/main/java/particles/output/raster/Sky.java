package particles.output.raster;

import java.awt.Color;

/** Day or night: colours of the background, the grid and text. */
public enum Sky {
    /** Daylight: a light sky and dark text. */
    DAY(0xa9c3dc, 0xf1f2f0, 0xdde2e6, 0xe8e4dc, 0xc9c3b8, new Text(0x2b3440, 0x5a6572, 0xb3261e, 0xf4f6f8)),
    /** Night: a dark sky, on which a glow is visible, and light text. */
    NIGHT(0x080b14, 0x1d2433, 0x0e1119, 0x23252b, 0x34373f, new Text(0xe9e6df, 0xa9afb9, 0xff8a80, 0x10141f));

    final int top;
    /** The colour of the sky at the horizon. */
    final int horizon;
    final int bottom;
    /** The colour of the ground. */
    public final int ground;
    /** The colour of the grid on the ground. */
    final int line;
    /** The colours of text. */
    public final Text text;

    /**
     * Colours of text.
     *
     * @param ink     the colour of text
     * @param soft    the colour of less important text
     * @param warning the colour of warnings
     * @param halo    the colour around labels of particles
     */
    public record Text(Color ink, Color soft, Color warning, Color halo) {
        private Text(int ink, int soft, int warning, int halo) {
            this(new Color(ink), new Color(soft), new Color(warning), new Color(halo));
        }
    }

    Sky(int top, int horizon, int bottom, int ground, int line, Text text) {
        this.top = top;
        this.horizon = horizon;
        this.bottom = bottom;
        this.ground = ground;
        this.line = line;
        this.text = text;
    }

    /** @return the colours of day or night */
    public static Sky of(boolean night) {
        return night ? NIGHT : DAY;
    }
}
