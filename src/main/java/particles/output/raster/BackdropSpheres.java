package particles.output.raster;

import java.util.List;
import particles.law.Sphere;
import particles.law.Vector3;

/**
 * Paints the scene's balls and the far inner walls of its hollows onto the background by ray casting, with four rays a
 * pixel for smooth edges. A ball is drawn smaller, and a hollow larger, by the radius of a particle, so that resting
 * particles touch it.
 */
final class BackdropSpheres {
    private static final int BALL = 0xaebccb;
    private static final int WALL = 0xdfe4e8;
    private static final int LINE = 0xb9c1c9;
    /** The spacing of grid lines on the wall of a hollow (radians). */
    private static final double SPACING = Math.PI / 12;

    private final CameraProjection view;
    private final Lighting lighting;
    // the hit of the current ray
    private double depth;
    private Vector3 normal;

    BackdropSpheres(CameraProjection view, Lighting lighting) {
        this.view = view;
        this.lighting = lighting;
    }

    /**
     * @param inset  the length by which balls are drawn smaller (m)
     * @param colour the picture so far, row by row; painted over
     * @param near   its nearness; changed where a sphere is nearer
     * @param shadow the columns of its pixels in the shadow map; spheres bear no shadows
     */
    void paint(List<Sphere> spheres, double inset, int[] colour, float[] near, float[] shadow) {
        for (Sphere sphere : spheres) {
            double radius = sphere.hollow() ? sphere.radius() + inset : Math.max(0.3 * sphere.radius(),
                    sphere.radius() - inset);
            for (int p = 0; p < colour.length; p++) {
                paint(sphere, radius, p, colour, near, shadow);
            }
        }
    }

    private void paint(Sphere sphere, double radius, int p, int[] colour, float[] near, float[] shadow) {
        int x = p % view.width;
        int y = p / view.width;
        int hits = 0;
        int redBlue = 0;
        int green = 0;
        float nearest = Float.NEGATIVE_INFINITY;
        for (int k = 0; k < 4; k++) {
            boolean hit = meets(sphere, radius, x + 0.25 + 0.5 * (k & 1), y + 0.25 + 0.5 * (k >> 1))
                    && view.nearness(depth) > near[p];
            int seen = hit ? shade(sphere, radius) : colour[p];
            redBlue += seen & 0xff00ff;
            green += seen & 0x00ff00;
            if (hit) {
                hits++;
                nearest = Math.max(nearest, (float) view.nearness(depth));
            }
        }
        colour[p] = Colours.mean(redBlue, green);
        if (hits > 1) {
            near[p] = nearest;
            shadow[p] = Backdrop.NO_SHADOWS;
        }
    }

    /** Intersects a ray with the visible side; the normal points towards the viewer. */
    private boolean meets(Sphere sphere, double radius, double px, double py) {
        Vector3 start = view.rayStart(px, py);
        Vector3 ray = view.rayDirection(px, py);
        Vector3 from = start.minus(sphere.centre());
        double a = ray.dot(ray);
        double b = from.dot(ray) / a;
        double c = (from.dot(from) - radius * radius) / a;
        double square = b * b - c;
        if (!(square >= 0)) {
            return false;
        }
        depth = sphere.hollow() ? -b + Math.sqrt(square) : -b - Math.sqrt(square);
        if (!view.isInFront(depth)) {
            return false;
        }
        normal = from.plus(ray.times(depth)).times((sphere.hollow() ? -1 : 1) / radius);
        return true;
    }

    private int shade(Sphere sphere, double radius) {
        Direction seen = view.turned(normal);
        if (!sphere.hollow()) {
            return lighting.shade(BALL, seen, 1);
        }
        double ring = Math.sqrt(normal.x() * normal.x() + normal.z() * normal.z());
        double foot = 1 / (view.scale(depth) * radius * SPACING * Math.max(0.15, Math.abs(seen.back())));
        double line = Math.max(GridLines.coverage(Math.asin(Math.max(-1, Math.min(1, normal.y()))) / SPACING, foot),
                ring > 0.05 ? GridLines.coverage(Math.atan2(normal.x(), normal.z()) / SPACING, foot / ring) : 0);
        return Colours.lit(Colours.mix(WALL, LINE, line), 0.65f + 0.35f * lighting.light(seen), 0);
    }
}
