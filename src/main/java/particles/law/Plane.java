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
    public double distance(double[] values, int place) {
        return distance(Vector3.at(values, place));
    }

    /** @return the same distance of a point given as a vector */
    public double distance(Vector3 at) {
        return at.minus(point).dot(normal);
    }

    @Override
    public Vector3 normal(double[] values, int place) {
        return normal;
    }

    @Override
    public double curvature(double[] values, int place) {
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
            coefficients[k] = distance(points, 3 * k);
        }
        return 4;
    }
}
