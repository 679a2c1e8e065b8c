package particles.output.raster;

import java.awt.Color;

/** The light in which a scene stands: what is behind it, and in which ink words are written. */
public enum Sky {
    DAY(0xa9c3dc, 0xf1f2f0, 0xdde2e6, 0xe8e4dc, 0xc9c3b8, 0x2b3440, 0x5a6572, 0xb3261e),
    NIGHT(0x080b14, 0x1d2433, 0x0e1119, 0x23252b, 0x34373f, 0xe9e6df, 0xa9afb9, 0xff8a80);

    final int top;
    public final int horizon;
    final int bottom;
    public final int ground;
    /** Of the grid on the ground. */
    final int line;
    public final Color ink;
    /** Of words that matter less. */
    public final Color soft;
    /** Of words that must not be missed. */
    public final Color warning;

    Sky(int top, int horizon, int bottom, int ground, int line, int ink, int soft,
            int warning) {
        this.top = top;
        this.horizon = horizon;
        this.bottom = bottom;
        this.ground = ground;
        this.line = line;
        this.ink = new Color(ink);
        this.soft = new Color(soft);
        this.warning = new Color(warning);
    }

    public static Sky of(boolean night) {
        return night ? NIGHT : DAY;
    }
}
