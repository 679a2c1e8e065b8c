package particles.output.charts;

import java.awt.Color;

/**
 * The format in which charts are drawn.
 *
 * @param slide whether each is a slide of 16:9 with large type and few curves; otherwise a picture for page and screen
 * @param svg   whether each is written as a vector graphic, too
 * @param dark  whether each is drawn on black, for a dark room
 * @param scale device pixels for each pixel of the layout
 */
public record ChartFormat(boolean slide, boolean svg, boolean dark, int scale) {
    /** Pictures for page and screen, as PNG alone. */
    public static final ChartFormat PAGE = new ChartFormat(false, false, false);

    /** The weighted mean of red, green and blue with which all lines have a contrast of 3 to 1 on black. */
    private static final double BRIGHT = 105;
    /** The type keeps its size in the layout: a smaller page with more device pixels has larger type. */
    static final int SLIDE_WIDTH = 640;
    static final int SLIDE_HEIGHT = 360;
    private static final int SLIDE_SCALE = 3;
    private static final int SCALE = 2;

    /** A format with so many device pixels that print and large screens get sharp lines. */
    public ChartFormat(boolean slide, boolean svg, boolean dark) {
        this(slide, svg, dark, slide ? SLIDE_SCALE : SCALE);
    }

    /** @return the same for a quick look, with a quarter of the device pixels; slides stay as they are */
    public ChartFormat quick() {
        return new ChartFormat(slide, svg, dark, slide ? scale : 1);
    }

    /**
     * @param onWhite the colour of something on white
     * @return the colour that it has in this format: on black one of the same hue that is as light as this one is dark;
     *         grey lines of the grid stay faint, but a colour that would be too dim to be seen is lightened
     */
    Color on(Color onWhite) {
        if (!dark) {
            return onWhite;
        }
        int red = onWhite.getRed();
        int green = onWhite.getGreen();
        int blue = onWhite.getBlue();
        int most = Math.max(red, Math.max(green, blue));
        int least = Math.min(red, Math.min(green, blue));
        int lighter = 255 - most - least;
        double dim = BRIGHT - (0.299 * red + 0.587 * green + 0.114 * blue + lighter);      // weights of ITU-R BT.601
        lighter += (int) Math.max(0, Math.min(Math.min(most - least, least), dim));
        return new Color(red + lighter, green + lighter, blue + lighter, onWhite.getAlpha());
    }

    /** @return the width of the layout of a page that is this wide without a format */
    int width(int wanted) {
        return slide ? SLIDE_WIDTH : wanted;
    }

    /** @return the height of the layout of a page that is this high without a format */
    int height(int wanted) {
        return slide ? SLIDE_HEIGHT : wanted;
    }
}
