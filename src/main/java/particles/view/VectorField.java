package particles.view;

/**
 * The vector field ds/dt of one degree of freedom over a grid in its state space: the arrows on the slide "Vectors show
 * the vector field" for s = (x, v). Arrow k stands at (x(k), v(k)) and points along (v(k), dv[k]).
 *
 * @param positions  the positions of the grid, rising in equal steps (m)
 * @param velocities its velocities, rising in equal steps (m/s)
 * @param dv         rates of the velocities, the accelerations, row by row from the lowest velocity (m/s&sup2;)
 */
public record VectorField(double[] positions, double[] velocities, double[] dv) {
    /** Creates a field with accelerations of 0 as yet. */
    public VectorField(double[] positions, double[] velocities) {
        this(positions, velocities, new double[positions.length * velocities.length]);
    }

    /** @return the position of arrow k (m) */
    public double x(int k) {
        return positions[k % positions.length];
    }

    /** @return the velocity of arrow k (m/s) */
    public double v(int k) {
        return velocities[k / positions.length];
    }
}
