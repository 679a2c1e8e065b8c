package particles.output.raster;

import particles.output.raster.CameraProjection.Place;

/**
 * The pixels of a picture within a radius of the line between two places; a disc if the two are the same.
 *
 * @param a      one end
 * @param b      the other end
 * @param radius the radius (pixels)
 */
public record Capsule(Place a, Place b, double radius) {
    /** A capsule farther out or larger (pixels) is not drawn, since coordinates lose precision. */
    private static final double FARTHEST = 1e7;

    /** Draws one pixel. */
    @FunctionalInterface
    public interface Pixel {
        /**
         * @param x     its column
         * @param y     its row
         * @param along the point of the line nearest to it: 0 at a, 1 at b
         * @param dx    the distance from that point to its centre, to the right
         * @param dy    the same downwards
         * @return whether something was drawn
         */
        boolean draw(int x, int y, double along, double dx, double dy);
    }

    /** @return whether it is in front of the camera, and near enough to the picture */
    boolean isDrawable() {
        return isDrawable(a) && isDrawable(b) && radius < FARTHEST;
    }

    private static boolean isDrawable(Place end) {
        return Math.abs(end.x()) < FARTHEST && Math.abs(end.y()) < FARTHEST && end.visible();   // false for NaN
    }

    /** @return the nearness of a point of the line */
    public double near(double along) {
        return a.near() + along * (b.near() - a.near());
    }

    /**
     * Draws the pixels in a picture of this size.
     *
     * @return whether any of them was drawn
     */
    public boolean draw(int width, int height, Pixel pixel) {
        if (!isDrawable()) {
            return false;
        }
        double wayX = b.x() - a.x();
        double wayY = b.y() - a.y();
        double square = wayX * wayX + wayY * wayY;
        double alongX = square > 1e-12 ? wayX / square : 0;
        double alongY = square > 1e-12 ? wayY / square : 0;
        // in a row, the columns of pixels within the radius of the endless line; all, if the line runs along the row
        double slope = wayX / wayY;
        double half = radius * Math.sqrt(1 + slope * slope);
        double least = Math.max(0, Math.min(a.x(), b.x()) - radius - 0.5);
        double most = Math.min(width - 1, Math.max(a.x(), b.x()) + radius - 0.5);
        boolean drawn = false;
        int end = Raster.last(Math.max(a.y(), b.y()) + radius, height - 1);
        for (int y = Raster.first(Math.min(a.y(), b.y()) - radius, 0); y <= end; y++) {
            double py = y + 0.5 - a.y();
            double middle = a.x() - 0.5 + py * slope;
            int last = (int) Math.floor(half < FARTHEST ? Math.min(most, middle + half) : most);
            for (int x = (int) Math.ceil(half < FARTHEST ? Math.max(least, middle - half) : least); x <= last; x++) {
                double px = x + 0.5 - a.x();
                double along = Math.max(0, Math.min(1, px * alongX + py * alongY));
                double dx = px - along * wayX;
                double dy = py - along * wayY;
                if (dx * dx + dy * dy <= radius * radius) {
                    drawn |= pixel.draw(x, y, along, dx, dy);
                }
            }
        }
        return drawn;
    }
}
