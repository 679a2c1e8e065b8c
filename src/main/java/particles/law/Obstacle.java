package particles.law;

/** The surface of a solid that particles stay outside of: a plane, a ball, the wall of a hollow. */
public interface Obstacle {
    /**
     * @param values has a point's three coordinates (m)
     * @param place  the index of the first of them
     * @return the signed distance from the surface (m): positive outside, negative inside the solid
     */
    double distance(double[] values, int place);

    /** @return the direction N out of the solid at a point, of length 1: the gradient of the distance */
    Vector3 normal(double[] values, int place);

    /**
     * The curvature of the surface: along a path, the second derivative of the distance is N . a + curvature
     * |v_t|&sup2;, where v_t is the tangential velocity.
     *
     * @return 0 for a plane, 1/r for a ball, -1/r for a hollow, with r the point's distance from the centre (1/m)
     */
    double curvature(double[] values, int place);

    /** @return whether the curvature is 0 everywhere */
    boolean isFlat();

    /**
     * Bounds the distance along a cubic curve: if no coefficient is negative, no point of the curve is inside the
     * solid.
     *
     * @param points       the four B&eacute;zier points of the curve, three coordinates each (m)
     * @param coefficients receives the B&eacute;zier (Bernstein) coefficients of a polynomial in the curve's parameter
     *                     that has the sign of the distance; length at least 7
     * @return the number of coefficients
     */
    int separation(double[] points, double[] coefficients);

    /**
     * Moves the surface outwards: the distance of a ball's surface from this one is that of its centre from the surface
     * that is raised by the ball's radius.
     *
     * @param height by how much the surface is raised (m), along its normals
     * @return what to add to each coefficient of {@link #separation}
     */
    default double raise(double height) {
        return -height;
    }
}
