package particles.output.raster;

import particles.output.raster.CameraProjection.Direction;
import particles.output.raster.CameraProjection.Place;

/** Draws balls and tubes, shaded at each sample. The view's places are in samples. */
public record RoundShapes(Raster raster, CameraProjection view, Lighting lighting) {
    /** The smallest radius; thinner shapes would fall between samples. */
    private static final double THINNEST = 0.8;

    /**
     * @param at     the place of the middle
     * @param radius the radius in samples
     * @param size   how far it stands out towards the camera (m)
     */
    public void ball(Place at, double radius, double size, int rgb) {
        double r = Math.max(radius, THINNEST);
        if (!new Capsule(at, at, r).isDrawable()) {
            return;
        }
        raster.touch(at, r);
        int x0 = Raster.first(at.x() - r, 0);
        int x1 = Raster.last(at.x() + r, raster.width - 1);
        int y1 = Raster.last(at.y() + r, raster.height - 1);
        float middle = (float) at.near();
        float front = (float) view.nearness(at.depth() - size);      // between the two, nearness is almost linear
        // a loop of its own: balls took 1.4 times as long as capsules without a length
        for (int y = Raster.first(at.y() - r, 0); y <= y1; y++) {
            float up = (float) ((at.y() - y - 0.5) / r);
            for (int x = x0, k = y * raster.width + x0; x <= x1; x++, k++) {
                float right = (float) ((x + 0.5 - at.x()) / r);
                float rest = 1 - right * right - up * up;
                if (rest >= 0) {
                    float back = (float) Math.sqrt(rest);
                    draw(k, middle + back * (front - middle), rgb, new Direction(right, up, back), 1);
                }
            }
        }
    }

    private boolean draw(int sample, float near, int rgb, Direction normal, float gloss) {
        boolean seen = near > raster.near[sample];
        if (seen) {
            raster.near[sample] = near;
            raster.colour[sample] = lighting.shade(rgb, normal, gloss);
        }
        return seen;
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
        double wayX = b.x() - a.x();
        double wayY = b.y() - a.y();
        double length = Math.max(1e-6, Math.sqrt(wayX * wayX + wayY * wayY));
        double unitX = wayX / length;
        double unitY = wayY / length;
        raster.touch(a, r);
        raster.touch(b, r);
        Capsule shape = new Capsule(a, b, r);
        return shape.draw(raster.width, raster.height, (x, y, along, dx, dy) -> {
            // the ends are shaded as the middle, so that a coil shows no joints
            double beyond = dx * unitX + dy * unitY;
            float right = (float) ((dx - beyond * unitX) / r);
            float up = (float) ((beyond * unitY - dy) / r);
            float back = (float) Math.sqrt(Math.max(0, 1 - right * right - up * up));
            return draw(y * raster.width + x, (float) shape.near(along), rgb, new Direction(right, up, back), 0.6f);
        });
    }
}
