package particles;

/**
 * A sphere that bounds a solid: a ball that particles stay outside of, or a hollow that they stay inside of.
 *
 * @param centre where its middle is (m)
 * @param radius R (m), positive
 * @param hollow whether particles belong inside
 */
public record Sphere(Vector3 centre, double radius, boolean hollow) {
    /** @throws IllegalArgumentException if the centre is not finite or the radius not positive */
    public Sphere {
        if (!centre.isFinite()) {
            throw new IllegalArgumentException("a sphere's centre has to be finite, not " + centre);
        }
        if (!(radius > 0) || !(radius <= Double.MAX_VALUE)) {
            throw new IllegalArgumentException("a sphere's radius has to be positive and finite, not " + radius);
        }
    }
}
