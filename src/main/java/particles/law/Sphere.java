package particles.law;

/**
 * A sphere that bounds a solid: a ball that particles stay outside of, or a hollow that they stay inside of.
 *
 * @param centre the centre (m)
 * @param radius R (m), positive
 * @param hollow whether particles belong inside
 */
public record Sphere(Vector3 centre, double radius, boolean hollow) implements Obstacle {
    private static final double[] CUBIC = {1, 3, 3, 1};
    private static final double[] SEXTIC = {1, 6, 15, 20, 15, 6, 1};

    /** @throws IllegalArgumentException if the centre is not finite or the radius not positive */
    public Sphere {
        centre.requireFinite("a sphere's centre");
        Require.positive("a sphere's radius", radius);
    }

    @Override
    public double distance(double[] values, int place) {
        double outside = fromCentre(values, place) - radius;
        return hollow ? -outside : outside;
    }

    /** A point's distance from the centre (m); a plain root, as there may be thousands of contacts. */
    private double fromCentre(double[] values, int place) {
        double x = values[place] - centre.x();
        double y = values[place + 1] - centre.y();
        double z = values[place + 2] - centre.z();
        return Math.sqrt(x * x + y * y + z * z);
    }

    /** {@inheritDoc} At the centre, where it is undefined, it points up. */
    @Override
    public Vector3 normal(double[] values, int place) {
        double length = fromCentre(values, place);
        return length == 0 ? new Vector3(0, 1, 0)
                : Vector3.at(values, place).minus(centre).times((hollow ? -1 : 1) / length);
    }

    @Override
    public double curvature(double[] values, int place) {
        double length = fromCentre(values, place);
        return (hollow ? -1 : 1) / (length > 0 ? length : radius);
    }

    @Override
    public boolean isFlat() {
        return false;
    }

    /** {@inheritDoc} R&sup2; becomes (R + height)&sup2;, for a hollow (R - height)&sup2;. */
    @Override
    public double raise(double height) {
        return -height * (hollow ? 2 * radius - height : 2 * radius + height);
    }

    /**
     * {@inheritDoc} |r|&sup2; - R&sup2; along a cubic is a polynomial of degree 6; for a hollow it is R&sup2; -
     * |r|&sup2;.
     */
    @Override
    public int separation(double[] points, double[] coefficients) {
        double side = hollow ? -1 : 1;
        for (int k = 0; k <= 6; k++) {
            coefficients[k] = -side * radius * radius;
        }
        Vector3[] r = new Vector3[4];
        for (int a = 0; a < 4; a++) {
            r[a] = Vector3.at(points, 3 * a).minus(centre);
        }
        for (int a = 0; a < 4; a++) {
            for (int b = 0; b < 4; b++) {
                coefficients[a + b] += side * CUBIC[a] * CUBIC[b] / SEXTIC[a + b] * r[a].dot(r[b]);
            }
        }
        return 7;
    }
}
