package particles.output.raster;

import particles.law.Sphere;
import particles.law.Vector3;
import particles.output.raster.CameraProjection.Direction;

/**
 * Paints a ball of the scene, or the far inner wall of a hollow, onto the background by ray casting, with four rays a
 * pixel for smooth edges. A ball is drawn smaller, and a hollow larger, by the radius of a particle, so that resting
 * particles touch it.
 */
final class BackdropSphere {
    private static final int BALL = 0xaebccb;
    private static final int WALL = 0xdfe4e8;
    private static final int LINE = 0xb9c1c9;
    /** The spacing of grid lines on the wall of a hollow (radians). */
    private static final double SPACING = Math.PI / 12;

    private final CameraProjection view;
    private final Lighting lighting;
    private final Sphere sphere;
    private final double radius;
    // of the current pixel
    private int hits;
    private float nearest;

    /** @param inset the length by which balls are drawn smaller (m) */
    BackdropSphere(CameraProjection view, Lighting lighting, Sphere sphere, double inset) {
        this.view = view;
        this.lighting = lighting;
        this.sphere = sphere;
        radius = sphere.hollow() ? sphere.radius() + inset : Math.max(0.3 * sphere.radius(), sphere.radius() - inset);
    }

    /**
     * @param colour the picture so far, row by row; painted over
     * @param near   its nearness; changed where the sphere is nearer
     * @param shadow the columns of its pixels in the shadow map; spheres bear no shadows
     */
    void paint(int[] colour, float[] near, float[] shadow) {
        for (int p = 0; p < colour.length; p++) {
            double x = p % view.width + 0.25;
            double y = p / view.width + 0.25;
            int behind = colour[p];
            float nearBehind = near[p];
            hits = 0;
            nearest = Float.NEGATIVE_INFINITY;
            colour[p] = Colours.mean(k -> seen(view.ray(x + 0.5 * (k & 1), y + 0.5 * (k >> 1)), behind, nearBehind));
            if (hits > 1) {
                near[p] = nearest;
                shadow[p] = Backdrop.NO_SHADOWS;
            }
        }
    }

    /** The colour along a ray: that of the visible side, or what is behind if the ray does not meet it. */
    private int seen(CameraProjection.Ray ray, int behind, float nearBehind) {
        Vector3 way = ray.direction();
        Vector3 from = ray.start().minus(sphere.centre());
        double a = way.dot(way);
        double b = from.dot(way) / a;
        double c = (from.dot(from) - radius * radius) / a;
        double root = Math.sqrt(b * b - c);             // NaN if it does not
        double depth = sphere.hollow() ? -b + root : -b - root;
        if (!(view.nearness(depth) > nearBehind) || !view.isInFront(depth)) {
            return behind;
        }
        hits++;
        nearest = Math.max(nearest, (float) view.nearness(depth));
        // towards the viewer
        return shade(depth, from.plus(way.times(depth)).times((sphere.hollow() ? -1 : 1) / radius));
    }

    private int shade(double depth, Vector3 normal) {
        Direction seen = view.turned(normal);
        if (!sphere.hollow()) {
            return lighting.shade(BALL, seen, 1);
        }
        double ring = Math.sqrt(normal.x() * normal.x() + normal.z() * normal.z());
        double foot = 1 / (view.scale(depth) * radius * SPACING * Math.max(0.15, Math.abs(seen.back())));
        double line = Math.max(Backdrop.gridLines(Math.asin(Math.max(-1, Math.min(1, normal.y()))) / SPACING, foot),
                ring > 0.05 ? Backdrop.gridLines(Math.atan2(normal.x(), normal.z()) / SPACING, foot / ring) : 0);
        return Colours.lit(Colours.mix(WALL, LINE, line), 0.65f + 0.35f * lighting.light(seen), 0);
    }
}
