package particles.output.raster;

import java.util.Arrays;

/**
 * A picture with a depth buffer and 2 x 2 supersampling: the nearest colour wins at each sample, and four samples are
 * averaged to smooth edges. Draws triangles; {@link RoundShapes} draws balls and tubes.
 */
public final class Raster {
    /** Samples a pixel in each direction. */
    public static final int SAMPLES = 2;
    /** Fixed-point colours have 16 bits after the point, and start a little above the value for round-off below 0. */
    private static final double ONE = 1 << 16;
    private static final double GUARD = ONE / 128;
    /** Widens each row a little, so that neighbouring triangles leave no gap (samples). */
    private static final double OVERLAP = 1e-9;
    /** Triangles with less than this part of their bounding square, or of one sample, have the colour of a corner. */
    private static final double THINNEST = 1e-9;

    /** The number of samples in a row. */
    public final int width;
    final int height;
    /** The colour of each sample, 0xRRGGBB, row by row; valid if something was drawn there. */
    public final int[] colour;
    /** The nearness of each sample; negative infinity if nothing was drawn there. */
    public final float[] near;
    // the edges of the current triangle: x at the middle of row 0, dx/dy, and whether the triangle is to the right
    private final double[] start = new double[3];
    private final double[] slope = new double[3];
    private final boolean[] isLeft = new boolean[3];
    // the rectangle drawn on since clearing, in samples
    private int left;
    private int top;
    private int right;
    private int bottom;

    /** Creates a raster for pictures of this size (pixels). */
    public Raster(int width, int height) {
        this.width = SAMPLES * width;
        this.height = SAMPLES * height;
        colour = new int[this.width * this.height];
        near = new float[this.width * this.height];
        Arrays.fill(near, Float.NEGATIVE_INFINITY);
        forget();
    }

    /** Clears the part of the picture that was drawn on. */
    public void clear() {
        for (int y = top; y < bottom; y++) {
            Arrays.fill(near, y * width + left, y * width + right, Float.NEGATIVE_INFINITY);
        }
        forget();
    }

    /** @return the nearness at a pixel; negative infinity if nothing was drawn */
    public float nearAt(int x, int y) {
        return near[SAMPLES * (y * width + x)];
    }

    /** @return how many of a pixel's four samples were drawn on, nearer than something behind */
    int covered(int x, int y, float behind) {
        int count = 0;
        for (int k = 0; k < 4; k++) {
            count += near[(SAMPLES * y + k / 2) * width + SAMPLES * x + k % 2] > behind ? 1 : 0;
        }
        return count;
    }

    private void forget() {
        left = width;
        top = height;
        right = 0;
        bottom = 0;
    }

    /** Extends the rectangle drawn on by the samples from (x0, y0) up to, not including, (x1, y1). */
    void touch(int x0, int y0, int x1, int y1) {
        left = Math.min(left, x0);
        top = Math.min(top, y0);
        right = Math.max(right, x1);
        bottom = Math.max(bottom, y1);
    }

    /** @return the first column of pixels that may have been drawn on */
    public int firstColumn() {
        return left / SAMPLES;
    }

    /** @return the column after the last one */
    public int endColumn() {
        return (right + SAMPLES - 1) / SAMPLES;
    }

    /** @return the first row of pixels that may have been drawn on */
    public int firstRow() {
        return top / SAMPLES;
    }

    /** @return the row after the last one */
    public int endRow() {
        return (bottom + SAMPLES - 1) / SAMPLES;
    }

    /**
     * Draws a triangle with colours interpolated between its corners.
     *
     * @param corners indices of corners; those of the triangle are three in a row
     * @param place   the place of the first one
     * @param xs      each corner's place from the left, in samples
     * @param ys      each corner's place from the top
     * @param ns      each corner's nearness
     * @param rgb     each corner's colour
     */
    public void triangle(int[] corners, int place, double[] xs, double[] ys, double[] ns, int[] rgb) {
        int a = corners[place];
        int b = corners[place + 1];
        int c = corners[place + 2];
        double ax = xs[a];
        double ay = ys[a];
        double bx = xs[b];
        double by = ys[b];
        double cx = xs[c];
        double cy = ys[c];
        int y0 = (int) Math.ceil(Math.max(0, Math.min(ay, Math.min(by, cy)) - 0.5));
        int y1 = (int) Math.floor(Math.min(height - 1, Math.max(ay, Math.max(by, cy)) - 0.5));
        int x0 = (int) Math.ceil(Math.max(0, Math.min(ax, Math.min(bx, cx)) - 0.5));
        int x1 = (int) Math.floor(Math.min(width - 1, Math.max(ax, Math.max(bx, cx)) - 0.5));
        double area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
        if (y0 > y1 || x0 > x1 || area == 0 || !Double.isFinite(area)) {
            return;
        }
        touch(x0, y0, x1 + 1, y1 + 1);
        double span = Math.max(Math.max(ax, Math.max(bx, cx)) - Math.min(ax, Math.min(bx, cx)),
                Math.max(ay, Math.max(by, cy)) - Math.min(ay, Math.min(by, cy)));
        // weights of corners b and c: changes with x and y; round-off would magnify them in a thin triangle
        double share = Math.abs(area) < Math.max(1, THINNEST * span * span) ? 0 : 1 / area;
        double bByX = (cy - ay) * share;
        double bByY = (ax - cx) * share;
        double cByX = (ay - by) * share;
        double cByY = (bx - ax) * share;
        double nearB = ns[b] - ns[a];
        double nearC = ns[c] - ns[a];
        double redA = channel(rgb[a], 16);
        double redB = channel(rgb[b], 16) - redA;
        double redC = channel(rgb[c], 16) - redA;
        double greenA = channel(rgb[a], 8);
        double greenB = channel(rgb[b], 8) - greenA;
        double greenC = channel(rgb[c], 8) - greenA;
        double blueA = channel(rgb[a], 0);
        double blueB = channel(rgb[b], 0) - blueA;
        double blueC = channel(rgb[c], 0) - blueA;
        float nearByX = (float) (bByX * nearB + cByX * nearC);
        int redByX = (int) (bByX * redB + cByX * redC);
        int greenByX = (int) (bByX * greenB + cByX * greenC);
        int blueByX = (int) (bByX * blueB + cByX * blueC);
        setEdge(0, ax, ay, bx, by, area);
        setEdge(1, bx, by, cx, cy, area);
        setEdge(2, cx, cy, ax, ay, area);
        for (int y = y0; y <= y1; y++) {
            double from = x0;
            double to = x1;
            for (int k = 0; k < 3; k++) {
                double cut = start[k] + y * slope[k];
                if (isLeft[k]) {
                    from = Math.max(from, cut - OVERLAP);
                } else {
                    to = Math.min(to, cut + OVERLAP);
                }
            }
            int first = (int) Math.ceil(from);
            int last = (int) Math.floor(to);
            if (first > last) {
                continue;
            }
            double u = (first + 0.5 - ax) * bByX + (y + 0.5 - ay) * bByY;
            double v = (first + 0.5 - ax) * cByX + (y + 0.5 - ay) * cByY;
            float n = (float) (ns[a] + u * nearB + v * nearC);
            int red = (int) (redA + u * redB + v * redC);
            int green = (int) (greenA + u * greenB + v * greenC);
            int blue = (int) (blueA + u * blueB + v * blueC);
            for (int at = y * width + first, end = y * width + last; at <= end; at++) {
                if (n > near[at]) {
                    near[at] = n;
                    colour[at] = red & 0xff0000 | green >> 8 & 0xff00 | blue >> 16;
                }
                n += nearByX;
                red += redByX;
                green += greenByX;
                blue += blueByX;
            }
        }
    }

    private void setEdge(int k, double fromX, double fromY, double toX, double toY, double area) {
        boolean cutsRows = Math.abs(toY - fromY) > OVERLAP;
        slope[k] = cutsRows ? (toX - fromX) / (toY - fromY) : 0;
        start[k] = cutsRows ? fromX - 0.5 + (0.5 - fromY) * slope[k] : Double.NEGATIVE_INFINITY;
        isLeft[k] = !cutsRows || fromY > toY == area > 0;
    }

    /** @return the first sample, from least on, whose centre lies beyond an edge */
    static int first(double edge, int least) {
        return (int) Math.max(least, Math.ceil(edge - 0.5));
    }

    /** @return the last sample, up to most, whose centre lies before an edge */
    static int last(double edge, int most) {
        return (int) Math.min(most, Math.floor(edge - 0.5));
    }

    private static double channel(int rgb, int shift) {
        return ONE * (rgb >> shift & 255) + GUARD;
    }
}
