package particles.output.charts;

import java.io.Serializable;

/**
 * The format in which charts are drawn.
 *
 * @param slide whether each is a slide of 16:9 with large type and few curves; otherwise a picture for page and screen
 * @param svg   whether each is written as a vector graphic, too
 * @param dark  whether each is drawn on black, for a dark room
 */
public record ChartFormat(boolean slide, boolean svg, boolean dark) implements Serializable {
    private static final long serialVersionUID = 1L;
    /** Pictures for page and screen, as PNG alone. */
    public static final ChartFormat PAGE = new ChartFormat(false, false);

    private static final int LIGHTEST = 0xff;
    private static final int CURVES = 6;
    private static final int CURVES_ON_A_SLIDE = 5;
    /** The type keeps its size in the layout: a smaller page with more device pixels has larger type. */
    private static final int SLIDE_WIDTH = 640;
    private static final int SLIDE_HEIGHT = 360;
    private static final int SLIDE_SCALE = 3;
    private static final int SCALE = 2;

    /** Creates a format on white. */
    public ChartFormat(boolean slide, boolean svg) {
        this(slide, svg, false);
    }

    /**
     * @param rgb a colour on white, 0xRRGGBB
     * @return the colour of the same hue and saturation that is as light as this one is dark
     */
    static int onBlack(int rgb) {
        int red = rgb >> 16 & LIGHTEST;
        int green = rgb >> 8 & LIGHTEST;
        int blue = rgb & LIGHTEST;
        int lighter = LIGHTEST - Math.max(red, Math.max(green, blue)) - Math.min(red, Math.min(green, blue));
        return red + lighter << 16 | green + lighter << 8 | blue + lighter;
    }

    /** @return the largest number of solvers in one panel */
    public int mostCurves() {
        return slide ? CURVES_ON_A_SLIDE : CURVES;
    }

    /** @return the width of the layout of a page that is this wide without a format */
    int width(int wanted) {
        return slide ? SLIDE_WIDTH : wanted;
    }

    /** @return the height of the layout of a page that is this high without a format */
    int height(int wanted) {
        return slide ? SLIDE_HEIGHT : wanted;
    }

    /** @return device pixels for each pixel of the layout, so that print and large screens get sharp lines */
    int scale() {
        return slide ? SLIDE_SCALE : SCALE;
    }
}
