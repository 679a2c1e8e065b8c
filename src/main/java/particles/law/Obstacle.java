package particles.law;

/** The boundary of a solid that particles stay outside of: a plane, a ball, the wall of a hollow. */
public interface Obstacle {
    /**
     * @param x a point's first coordinate (m)
     * @param y its second (m)
     * @param z its third (m)
     * @return how far the point is outside; negative inside the solid (m)
     */
    double distance(double x, double y, double z);

    /** @return the direction N out of the solid at a point, of length 1: the gradient of the distance */
    Vector3 normal(double x, double y, double z);

    /**
     * How the distance curves: along a path its second derivative is N . a + curvature |v_t|&sup2;, with v_t the
     * velocity across N.
     *
     * @return 0 for a plane, 1/r for a ball, -1/r for a hollow, with r the point's distance from the centre (1/m)
     */
    double curvature(double x, double y, double z);

    /** @return whether the curvature is 0 everywhere */
    boolean isFlat();

    /**
     * Where a cubic curve is outside. The result bounds it: where no coefficient is negative, no point of the curve is
     * inside.
     *
     * @param points       the four B&eacute;zier points of the curve, three coordinates each (m)
     * @param coefficients receives the B&eacute;zier (Bernstein) coefficients of a polynomial of the curve's parameter
     *                     that has the sign of the distance; at least seven places
     * @return how many coefficients it has
     */
    int separation(double[] points, double[] coefficients);
}
