package particles.output.raster;

import java.util.Arrays;

/**
 * A picture with a depth buffer and 2 x 2 supersampling: the nearest colour wins at each sample, and four samples are
 * averaged to smooth edges. Draws triangles; {@link RoundShapes} draws balls and tubes.
 */
public final class Raster {
    /** Samples a pixel in each direction. */
    public static final int SAMPLES = 2;
    /** The largest value that truncates to 255. */
    private static final double BRIGHTEST = 255.99;

    /** The number of samples in a row. */
    public final int width;
    final int height;
    /** The colour of each sample, 0xRRGGBB, row by row; valid if something was drawn there. */
    public final int[] colour;
    /** The nearness of each sample; negative infinity if nothing was drawn there. */
    public final float[] near;
    // colours of the current triangle: blue, green, red at its first corner, and differences to the others
    private final int[] base = new int[3];
    private final int[] toB = new int[3];
    private final int[] toC = new int[3];
    // and along a row of samples, with their increments
    private final int[] value = new int[3];
    private final int[] change = new int[3];
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
     * Draws a triangle with colours interpolated between its corners, which are given by index.
     *
     * @param xs   each corner's place from the left, in samples
     * @param ys   each corner's place from the top
     * @param ns   each corner's nearness
     * @param rgb  each corner's colour
     */
    public void triangle(int a, int b, int c, double[] xs, double[] ys, double[] ns, int[] rgb) {
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
        // weights of corners b and c at a sample, and how they change with x and y
        double bByX = (cy - ay) / area;
        double bByY = (ax - cx) / area;
        double cByX = (ay - by) / area;
        double cByY = (bx - ax) / area;
        double nByX = bByX * (ns[b] - ns[a]) + cByX * (ns[c] - ns[a]);
        for (int channel = 0; channel < 3; channel++) {
            int at = rgb[a] >> 8 * channel & 255;
            toB[channel] = (rgb[b] >> 8 * channel & 255) - at;
            toC[channel] = (rgb[c] >> 8 * channel & 255) - at;
            base[channel] = at;
        }
        for (int y = y0; y <= y1; y++) {
            double py = y + 0.5;
            // weights at x = 0.5 of this row, then the range of x in which all three are 0 or more
            double wb = (0.5 - ax) * bByX + (py - ay) * bByY;
            double wc = (0.5 - ax) * cByX + (py - ay) * cByY;
            double wa = 1 - wb - wc;
            double aByX = -bByX - cByX;
            double from = Math.max(x0, Math.max(lower(wa, aByX), Math.max(lower(wb, bByX), lower(wc, cByX))));
            double to = Math.min(x1, Math.min(upper(wa, aByX), Math.min(upper(wb, bByX), upper(wc, cByX))));
            int first = (int) Math.ceil(from);
            int last = (int) Math.floor(to);
            if (first > last) {
                continue;
            }
            double u = wb + first * bByX;
            double v = wc + first * cByX;
            for (int channel = 0; channel < 3; channel++) {
                setOut(channel, base[channel] + u * toB[channel] + v * toC[channel],
                        bByX * toB[channel] + cByX * toC[channel], last - first);
            }
            double n = ns[a] + u * (ns[b] - ns[a]) + v * (ns[c] - ns[a]);
            fill(y * width + first, y * width + last, (float) n, (float) nByX);
        }
    }

    /** A colour channel along a row in units of 1/65536, clamped because thin triangles magnify round-off. */
    private void setOut(int channel, double first, double slope, int steps) {
        double from = Math.max(0, Math.min(BRIGHTEST, first));
        double to = Math.max(0, Math.min(BRIGHTEST, first + steps * slope));
        value[channel] = (int) (65536 * from);
        change[channel] = steps == 0 ? 0 : (int) (65536 * (to - from) / steps);
    }

    private void fill(int first, int last, float nearness, float nearnessChange) {
        float n = nearness;
        int red = value[2];
        int green = value[1];
        int blue = value[0];
        int redChange = change[2];
        int greenChange = change[1];
        int blueChange = change[0];
        for (int at = first; at <= last; at++) {
            if (n > near[at]) {
                near[at] = n;
                colour[at] = red & 0xff0000 | green >> 8 & 0xff00 | blue >> 16;
            }
            n += nearnessChange;
            red += redChange;
            green += greenChange;
            blue += blueChange;
        }
    }

    /** The first sample where w + x slope is not negative, so that neighbouring triangles leave no gap. */
    private static double lower(double w, double slope) {
        return slope > 0 ? -w / slope - 1e-9 : slope == 0 && w < 0 ? Double.POSITIVE_INFINITY
                : Double.NEGATIVE_INFINITY;
    }

    private static double upper(double w, double slope) {
        return slope < 0 ? -w / slope + 1e-9 : slope == 0 && w < 0 ? Double.NEGATIVE_INFINITY
                : Double.POSITIVE_INFINITY;
    }
}
