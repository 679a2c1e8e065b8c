package particles.output.raster;

import particles.output.raster.CameraProjection.Place;

/** Draws balls and tubes, shaded at each sample. The view's places are in samples. */
public record RoundShapes(Raster raster, CameraProjection view, Lighting lighting) {
    /** The smallest radius; thinner shapes would fall between samples. */
    private static final double THINNEST = 0.8;
    /** Shapes farther out (samples) are not drawn, since coordinates lose precision. */
    private static final double FARTHEST = 1e7;

    private static boolean isDrawable(Place at, double radius) {
        boolean near = Math.abs(at.x()) < FARTHEST && Math.abs(at.y()) < FARTHEST && radius < FARTHEST;
        return near && at.visible();            // false for NaN
    }

    /**
     * @param at     the place of the middle
     * @param radius the radius in samples
     * @param size   how far it stands out towards the camera (m)
     */
    public void ball(Place at, double radius, double size, int rgb) {
        double x = at.x();
        double y = at.y();
        double r = Math.max(radius, THINNEST);
        if (!isDrawable(at, r)) {
            return;
        }
        int y0 = Raster.first(y - r, 0);
        int y1 = Raster.last(y + r, raster.height - 1);
        int x0 = Raster.first(x - r, 0);
        int x1 = Raster.last(x + r, raster.width - 1);
        if (y0 > y1 || x0 > x1) {
            return;
        }
        raster.touch(x0, y0, x1 + 1, y1 + 1);
        float middle = (float) at.near();
        float front = (float) view.nearness(at.depth() - size);      // between the two, nearness is almost linear
        for (int sy = y0; sy <= y1; sy++) {
            float ny = (float) ((y - sy - 0.5) / r);
            for (int sx = x0, k = sy * raster.width + x0; sx <= x1; sx++, k++) {
                float nx = (float) ((sx + 0.5 - x) / r);
                float rest = 1 - nx * nx - ny * ny;
                if (rest < 0) {
                    continue;
                }
                float nz = (float) Math.sqrt(rest);
                float n = middle + nz * (front - middle);
                if (n > raster.near[k]) {
                    raster.near[k] = n;
                    raster.colour[k] = lighting.shade(rgb, new Direction(nx, ny, nz), 1);
                }
            }
        }
    }

    /**
     * Draws tubes with round ends from each point to the next.
     *
     * @param radius the radius of the tubes (m)
     * @return whether any of them is visible so far
     */
    public boolean tubes(Place[] points, double radius, int rgb) {
        boolean seen = false;
        for (int k = 1; k < points.length; k++) {
            seen |= tube(points[k - 1], points[k], radius, rgb);
        }
        return seen;
    }

    /**
     * A tube with round ends between two points.
     *
     * @param radius the radius of the tube (m)
     * @return whether any of it is visible so far
     */
    public boolean tube(Place a, Place b, double radius, int rgb) {
        double r = Math.max(radius * (a.scale() + b.scale()) / 2, THINNEST);
        if (!isDrawable(a, r) || !isDrawable(b, r)) {
            return false;
        }
        double ax = a.x();
        double ay = a.y();
        boolean seen = false;
        double dx = b.x() - ax;
        double dy = b.y() - ay;
        double square = dx * dx + dy * dy;
        double length = Math.sqrt(square);
        double acrossX = length > 1e-6 ? -dy / length : 0;
        double acrossY = length > 1e-6 ? dx / length : 1;
        int y0 = Raster.first(Math.min(ay, b.y()) - r, 0);
        int y1 = Raster.last(Math.max(ay, b.y()) + r, raster.height - 1);
        double least = Math.max(0, Math.min(ax, b.x()) - r - 0.5);
        double most = Math.min(raster.width - 1, Math.max(ax, b.x()) + r - 0.5);
        for (int sy = y0; sy <= y1; sy++) {
            double py = sy + 0.5 - ay;
            double from = least;
            double to = most;
            if (Math.abs(acrossX) > 1e-6) {             // only samples within r of the line
                double at = ax - 0.5 - py * acrossY / acrossX;
                double half = r / Math.abs(acrossX);
                from = Math.max(from, at - half);
                to = Math.min(to, at + half);
            }
            int first = (int) Math.ceil(from);
            int last = (int) Math.floor(to);
            if (first > last) {
                continue;
            }
            raster.touch(first, sy, last + 1, sy + 1);
            for (int sx = first, at = sy * raster.width + first; sx <= last; sx++, at++) {
                double px = sx + 0.5 - ax;
                double along = square > 1e-12 ? Math.max(0, Math.min(1, (px * dx + py * dy) / square)) : 0;
                double ox = px - along * dx;
                double oy = py - along * dy;
                double off = (ox * ox + oy * oy) / (r * r);
                float n = (float) (a.near() + along * (b.near() - a.near()));
                if (off > 1 || !(n > raster.near[at])) {
                    continue;
                }
                seen = true;
                raster.near[at] = n;
                float side = (float) ((ox * acrossX + oy * acrossY) / r);
                float nx = side * (float) acrossX;
                float ny = -side * (float) acrossY;
                float nz = (float) Math.sqrt(Math.max(0, 1 - nx * nx - ny * ny));
                raster.colour[at] = lighting.shade(rgb, new Direction(nx, ny, nz), 0.6f);
            }
        }
        return seen;
    }
}
