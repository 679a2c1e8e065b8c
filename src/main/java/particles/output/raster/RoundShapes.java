package particles.output.raster;

/** Draws balls and tubes, shaded at each sample. Positions and radii are in samples. */
public record RoundShapes(Raster raster, CameraProjection view, Lighting lighting) {
    /** The smallest radius; thinner shapes would fall between samples. */
    private static final double THINNEST = 0.8;
    /** Shapes farther out (samples) are not drawn, since coordinates lose precision. */
    private static final double FARTHEST = 1e7;

    private static boolean isDrawable(double x, double y, double radius) {
        return Math.abs(x) < FARTHEST && Math.abs(y) < FARTHEST && radius < FARTHEST;      // false for NaN
    }

    /**
     * @param x      the middle, from the left
     * @param y      the middle, from the top
     * @param radius the radius in samples
     * @param depth  the depth of the middle (m)
     * @param size   the radius in space (m)
     */
    public void ball(double x, double y, double radius, double depth, double size, int rgb) {
        double r = Math.max(radius, THINNEST);
        if (!isDrawable(x, y, r)) {
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
        float middle = (float) view.nearness(depth);
        float front = (float) view.nearness(depth - size);      // between the two, nearness is almost linear
        for (int sy = y0; sy <= y1; sy++) {
            float ny = (float) ((y - sy - 0.5) / r);
            for (int sx = x0, at = sy * raster.width + x0; sx <= x1; sx++, at++) {
                float nx = (float) ((sx + 0.5 - x) / r);
                float rest = 1 - nx * nx - ny * ny;
                if (rest < 0) {
                    continue;
                }
                float nz = (float) Math.sqrt(rest);
                float n = middle + nz * (front - middle);
                if (n > raster.near[at]) {
                    raster.near[at] = n;
                    raster.colour[at] = lighting.shade(rgb, new Direction(nx, ny, nz), 1);
                }
            }
        }
    }

    /**
     * A tube with round ends between two points.
     *
     * @param radius the radius in samples, in the middle of the tube
     * @param na     the nearness of the first end
     * @param nb     the nearness of the second end
     * @return whether any of it is visible so far
     */
    public boolean tube(double ax, double ay, double na, double bx, double by, double nb, double radius, int rgb) {
        double r = Math.max(radius, THINNEST);
        if (!isDrawable(ax, ay, r) || !isDrawable(bx, by, r)) {
            return false;
        }
        boolean seen = false;
        double dx = bx - ax;
        double dy = by - ay;
        double square = dx * dx + dy * dy;
        double length = Math.sqrt(square);
        double acrossX = length > 1e-6 ? -dy / length : 0;
        double acrossY = length > 1e-6 ? dx / length : 1;
        int y0 = Raster.first(Math.min(ay, by) - r, 0);
        int y1 = Raster.last(Math.max(ay, by) + r, raster.height - 1);
        double least = Math.max(0, Math.min(ax, bx) - r - 0.5);
        double most = Math.min(raster.width - 1, Math.max(ax, bx) + r - 0.5);
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
                float n = (float) (na + along * (nb - na));
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
