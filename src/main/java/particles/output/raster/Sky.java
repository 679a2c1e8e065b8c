package particles.output.raster;

import java.awt.Color;
import particles.view.RenderOptions;

/**
 * The colours of the background, the grid and text.
 *
 * @param top     the colour of the sky above
 * @param horizon the colour of the sky at the horizon
 * @param bottom  the colour below, where there is no ground
 * @param ground  the colour of the ground
 * @param line    the colour of the grid on the ground
 * @param text    the colours of text
 */
public record Sky(int top, int horizon, int bottom, int ground, int line, Text text) {
    /** Daylight: a light sky and dark text. */
    private static final Sky DAY = new Sky(0xa9c3dc, 0xf1f2f0, 0xdde2e6, 0xe8e4dc, 0xc9c3b8,
            new Text(0x2b3440, 0x5a6572, 0xb3261e, 0xf4f6f8));
    /** Night: a dark sky, on which a glow is visible, and light text. */
    private static final Sky NIGHT = new Sky(0x080b14, 0x1d2433, 0x0e1119, 0x23252b, 0x34373f,
            new Text(0xe9e6df, 0xa9afb9, 0xff8a80, 0x10141f));

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

    /** @return the colours of day or night, or one colour behind everything */
    public static Sky of(RenderOptions look) {
        Sky sky = look.style().night() ? NIGHT : DAY;
        return look.colours().background().map(colour -> new Sky(colour, colour, colour, sky.ground, sky.line,
                sky.text)).orElse(sky);
    }
}
