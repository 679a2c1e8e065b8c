package particles.law;

/**
 * A plane that bounds a half-space: particles belong on the side to which the normal points.
 *
 * @param point  any point of the plane (m)
 * @param normal N, pointing out of the solid; it is normalised
 */
public record Plane(Vector3 point, Vector3 normal) implements Obstacle {
    /** @throws IllegalArgumentException if the normal has no direction or the point is not finite */
    public Plane {
        point.requireFinite("a plane's point");
        normal = normal.normalized();
    }

    /** @return a level ground at the given height */
    public static Plane ground(double height) {
        return new Plane(new Vector3(0, height, 0), new Vector3(0, 1, 0));
    }

    @Override
    public double distance(double x, double y, double z) {
        return (x - point.x()) * normal.x() + (y - point.y()) * normal.y() + (z - point.z()) * normal.z();
    }

    @Override
    public Vector3 normal(double x, double y, double z) {
        return normal;
    }

    @Override
    public double curvature(double x, double y, double z) {
        return 0;
    }

    @Override
    public boolean isFlat() {
        return true;
    }

    /** {@inheritDoc} The distance itself is a cubic, and its coefficients are the distances of the points. */
    @Override
    public int separation(double[] points, double[] coefficients) {
        for (int k = 0; k < 4; k++) {
            coefficients[k] = distance(points[3 * k], points[3 * k + 1], points[3 * k + 2]);
        }
        return 4;
    }
}
