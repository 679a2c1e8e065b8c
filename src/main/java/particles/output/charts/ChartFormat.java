package particles.output.charts;

/**
 * The format in which charts are drawn.
 *
 * @param slide whether each is a slide of 16:9 with large type and few curves; otherwise a picture for page and screen
 * @param svg   whether each is written as a vector graphic, too
 */
public record ChartFormat(boolean slide, boolean svg) {
    /** Pictures for page and screen, as PNG alone. */
    public static final ChartFormat PAGE = new ChartFormat(false, false);

    private static final int CURVES = 6;
    private static final int CURVES_ON_A_SLIDE = 5;
    /** The type keeps its size in the layout: a smaller page with more device pixels has larger type. */
    private static final int SLIDE_WIDTH = 640;
    private static final int SLIDE_HEIGHT = 360;
    private static final int SLIDE_SCALE = 3;
    private static final int SCALE = 2;

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
