package particles.output.raster;

import java.util.Arrays;
import particles.output.raster.CameraProjection.Place;

/**
 * A picture with a depth buffer and 2 x 2 supersampling: the nearest colour wins at each sample, and four samples are
 * averaged to smooth edges. Draws triangles; {@link RoundShapes} draws balls and tubes.
 */
public final class Raster {
    /** Samples a pixel in each direction. */
    public static final int SAMPLES = 2;
    /** Keeps a colour that all corners share from falling to the next one below by round-off. */
    private static final double GUARD = 1.0 / 128;
    /** Widens triangles a little (in weights of corners), so that neighbours leave no gap. */
    private static final double OVERLAP = 1e-9;

    /** The number of samples in a row. */
    public final int width;
    final int height;
    /** The colour of each sample, 0xRRGGBB, row by row; valid if something was drawn there. */
    public final int[] colour;
    /** The nearness of each sample; negative infinity if nothing was drawn there. */
    public final float[] near;
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
    float nearAt(int x, int y) {
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

    /** Extends the rectangle drawn on by the samples within a distance of a place. */
    void touch(Place at, double distance) {
        left = Math.min(left, first(at.x() - distance, 0));
        top = Math.min(top, first(at.y() - distance, 0));
        right = Math.max(right, 1 + last(at.x() + distance, width - 1));
        bottom = Math.max(bottom, 1 + last(at.y() + distance, height - 1));
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
     * @param offset  the index of the first of them
     * @param places  where each corner is seen, in samples
     * @param rgb     each corner's colour
     */
    public void triangle(int[] corners, int offset, Place[] places, int[] rgb) {
        Place a = places[corners[offset]];
        Place b = places[corners[offset + 1]];
        Place c = places[corners[offset + 2]];
        double abX = b.x() - a.x();
        double abY = b.y() - a.y();
        double acX = c.x() - a.x();
        double acY = c.y() - a.y();
        double area = abX * acY - acX * abY;
        int y0 = first(Math.min(a.y(), Math.min(b.y(), c.y())), 0);
        int y1 = last(Math.max(a.y(), Math.max(b.y(), c.y())), height - 1);
        int x0 = first(Math.min(a.x(), Math.min(b.x(), c.x())), 0);
        int x1 = last(Math.max(a.x(), Math.max(b.x(), c.x())), width - 1);
        boolean visible = a.visible() && b.visible() && c.visible();
        if (!visible || y0 > y1 || x0 > x1 || area == 0 || !Double.isFinite(area)) {
            return;
        }
        touch(a, 0);
        touch(b, 0);
        touch(c, 0);
        int rgbA = rgb[corners[offset]];
        int rgbB = rgb[corners[offset + 1]];
        int rgbC = rgb[corners[offset + 2]];
        double uByX = acY / area;
        double vByX = -abY / area;
        for (int y = y0; y <= y1; y++) {
            double dx = x0 + 0.5 - a.x();
            double dy = y + 0.5 - a.y();
            double u = (dx * acY - dy * acX) / area;        // the weights of corners a, b and c are 1 - u - v, u and v
            double v = (dy * abX - dx * abY) / area;
            for (int at = y * width + x0, end = y * width + x1; at <= end; at++, u += uByX, v += vByX) {
                double w = 1 - u - v;
                if (u < -OVERLAP || v < -OVERLAP || w < -OVERLAP) {
                    continue;
                }
                float n = (float) (w * a.near() + u * b.near() + v * c.near());
                if (n > near[at]) {
                    near[at] = n;
                    int mixed = 0;
                    for (int shift = 16; shift >= 0; shift -= 8) {
                        mixed |= (int) (w * (rgbA >> shift & 255) + u * (rgbB >> shift & 255)
                                + v * (rgbC >> shift & 255) + GUARD) << shift;
                    }
                    colour[at] = mixed;
                }
            }
        }
    }

    /** @return the first sample, from least on, whose centre lies beyond an edge */
    public static int first(double edge, int least) {
        return (int) Math.max(least, Math.ceil(edge - 0.5));
    }

    /** @return the last sample, up to most, whose centre lies before an edge */
    public static int last(double edge, int most) {
        return (int) Math.min(most, Math.floor(edge - 0.5));
    }
}
