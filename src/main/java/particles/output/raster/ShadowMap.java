package particles.output.raster;

import java.util.Arrays;
import particles.law.Plane;
import particles.law.Vector3;

/**
 * The shadow map of a plane: shapes are projected along the light onto a square grid of the plane, which is then
 * blurred for soft edges. Coverage is from 0 to 1.
 */
public final class ShadowMap {
    private static final int SIZE = 960;
    /** Three box filters of this half width make a smooth blur. */
    private static final int BLUR = 2;
    private static final int MARGIN = 3 * BLUR + 1;

    final Vector3 axisU;
    final Vector3 axisV;
    private final Plane plane;
    private final Vector3 lamp;
    private final double lampRise;
    private final double middleU;
    private final double middleV;
    private final double cells;
    private final float[] coverage = new float[SIZE * SIZE];
    private final float[] work = new float[SIZE * SIZE];
    private int left;
    private int top;
    private int right;
    private int bottom;

    /**
     * @param plane  the plane of the shadow
     * @param lamp   the direction towards the lamp, a unit vector
     * @param middle a point whose projection is the centre of the square
     * @param extent the side of the square (m)
     */
    ShadowMap(Plane plane, Vector3 lamp, Vector3 middle, double extent) {
        this.plane = plane;
        this.lamp = lamp;
        Vector3 normal = plane.normal();
        Vector3 other = Math.abs(normal.x()) < 0.7 ? new Vector3(1, 0, 0) : new Vector3(0, 0, 1);
        axisV = normal.cross(other).normalized();
        axisU = axisV.cross(normal);
        lampRise = lamp.dot(normal);
        cells = SIZE / extent;
        Vector3 foot = middle.minus(lamp.times(plane.distance(middle.x(), middle.y(), middle.z()) / lampRise))
                .minus(plane.point());
        middleU = foot.dot(axisU);
        middleV = foot.dot(axisV);
        clear();
    }

    /** @return whether the lamp shines on the plane's outer side */
    static boolean isLit(Plane plane, Vector3 lamp) {
        return lamp.dot(plane.normal()) > 0.05;
    }

    /** Removes all shadows. */
    public void clear() {
        Arrays.fill(coverage, 0);
        left = SIZE;
        top = SIZE;
        right = 0;
        bottom = 0;
    }

    /** @return the column of the map to which a point is projected; not a whole number */
    public double column(double x, double y, double z) {
        return place(x, y, z, axisU, middleU);
    }

    /** @return the row of the map to which a point is projected; not a whole number */
    public double row(double x, double y, double z) {
        return place(x, y, z, axisV, middleV);
    }

    private double place(double x, double y, double z, Vector3 axis, double middle) {
        double h = plane.distance(x, y, z) / lampRise;
        double along = (x - h * lamp.x() - plane.point().x()) * axis.x()
                + (y - h * lamp.y() - plane.point().y()) * axis.y()
                + (z - h * lamp.z() - plane.point().z()) * axis.z();
        return (along - middle) * cells + SIZE / 2.0;
    }

    /** @return whether a point is on the plane's outer side, so that it casts a shadow */
    public boolean isAbove(double x, double y, double z) {
        return plane.distance(x, y, z) >= 0;
    }

    /** Adds a round spot; one smaller than a cell is paler. */
    public void disc(double column, double row, double radius) {
        double r = Math.max(radius * cells, 0.6);
        float strength = (float) Math.min(1, radius * cells / r);
        int x0 = Raster.first(column - r, MARGIN);
        int x1 = Raster.last(column + r, SIZE - 1 - MARGIN);
        int y0 = Raster.first(row - r, MARGIN);
        int y1 = Raster.last(row + r, SIZE - 1 - MARGIN);
        for (int y = y0; y <= y1; y++) {
            for (int x = x0; x <= x1; x++) {
                double dx = x + 0.5 - column;
                double dy = y + 0.5 - row;
                if (dx * dx + dy * dy <= r * r) {
                    coverage[y * SIZE + x] = Math.max(coverage[y * SIZE + x], strength);
                }
            }
        }
        touch(x0, y0, x1, y1);
    }

    /** Adds a strip between two points, as a row of discs. */
    public void strip(double c0, double r0, double c1, double r1, double radius) {
        double length = Math.hypot(c1 - c0, r1 - r0);
        if (!(length < 4 * SIZE)) {
            return;
        }
        int steps = (int) Math.ceil(length);
        for (int k = 0; k <= steps; k++) {
            double part = steps == 0 ? 0 : (double) k / steps;
            disc(c0 + part * (c1 - c0), r0 + part * (r1 - r0), radius);
        }
    }

    /** Adds a triangle, given by the columns and rows of its corners. */
    public void triangle(double ax, double ay, double bx, double by, double cx, double cy) {
        double area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
        if (!Double.isFinite(area)) {
            return;
        }
        int x0 = (int) Math.max(MARGIN, Math.floor(Math.min(ax, Math.min(bx, cx))));
        int x1 = (int) Math.min(SIZE - 1 - MARGIN, Math.ceil(Math.max(ax, Math.max(bx, cx))));
        int y0 = (int) Math.max(MARGIN, Math.floor(Math.min(ay, Math.min(by, cy))));
        int y1 = (int) Math.min(SIZE - 1 - MARGIN, Math.ceil(Math.max(ay, Math.max(by, cy))));
        double sign = area < 0 ? -1 : 1;
        for (int y = y0; y <= y1; y++) {
            double py = y + 0.5;
            for (int x = x0; x <= x1; x++) {
                double px = x + 0.5;
                double ab = (bx - ax) * (py - ay) - (px - ax) * (by - ay);
                double bc = (cx - bx) * (py - by) - (px - bx) * (cy - by);
                double ca = (ax - cx) * (py - cy) - (px - cx) * (ay - cy);
                if (sign * ab >= 0 && sign * bc >= 0 && sign * ca >= 0) {
                    coverage[y * SIZE + x] = 1;
                }
            }
        }
        touch(x0, y0, x1, y1);
    }

    private void touch(int x0, int y0, int x1, int y1) {
        if (x0 <= x1 && y0 <= y1) {
            left = Math.min(left, x0 - MARGIN);
            top = Math.min(top, y0 - MARGIN);
            right = Math.max(right, x1 + 1 + MARGIN);
            bottom = Math.max(bottom, y1 + 1 + MARGIN);
        }
    }

    /** Blurs the map once all shapes are added. */
    public void blur() {
        for (int pass = 0; pass < 3 && left < right; pass++) {
            box(coverage, work, true);
            box(work, coverage, false);
        }
    }

    /** A moving mean along rows or columns, limited to the touched area. */
    private void box(float[] in, float[] out, boolean alongRows) {
        int lineStep = alongRows ? SIZE : 1;
        int step = alongRows ? 1 : SIZE;
        int from = alongRows ? left : top;
        int to = alongRows ? right : bottom;
        float share = 1f / (2 * BLUR + 1);
        int lines = alongRows ? bottom : right;
        for (int line = alongRows ? top : left; line < lines; line++) {
            int start = line * lineStep;
            float sum = 0;
            for (int k = from - BLUR; k < to; k++) {
                int enters = k + BLUR;
                if (enters < to) {
                    sum += in[start + enters * step];
                }
                if (k >= from) {
                    out[start + k * step] = Math.max(0, sum) * share;
                    int leaves = k - BLUR;
                    if (leaves >= from) {
                        sum -= in[start + leaves * step];
                    }
                }
            }
        }
    }

    /** @return whether there may be shadow at a point of the map */
    boolean isTouched(float column, float row) {
        return column >= left + 0.5f && column < right - 0.5f && row >= top + 0.5f && row < bottom - 0.5f;
    }

    /** @return the interpolated coverage at a touched point of the map */
    float at(float column, float row) {
        float c = column - 0.5f;
        float r = row - 0.5f;
        int x = (int) c;
        int y = (int) r;
        float u = c - x;
        float v = r - y;
        int at = y * SIZE + x;
        return (1 - v) * ((1 - u) * coverage[at] + u * coverage[at + 1])
                + v * ((1 - u) * coverage[at + SIZE] + u * coverage[at + SIZE + 1]);
    }
}
