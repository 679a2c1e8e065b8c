package particles.view;

import java.util.stream.IntStream;

/**
 * The vector field ds/dt of one degree of freedom over its state space: the arrows on the slide "Vectors show the
 * vector field" for s = (x, v). Arrow k stands at (x[k], v[k]) and points along (v[k], dv[k]). The arrows fill a grid of
 * equal cells, row by row, from the lowest x and v.
 *
 * @param x  positions (m)
 * @param v  velocities (m/s)
 * @param dv rates of the velocities, the accelerations (m/s&sup2;)
 */
public record VectorField(double[] x, double[] v, double[] dv) {
    /** @return arrows at all pairs of these positions and velocities, with accelerations of 0 as yet */
    public static VectorField over(double[] positions, double[] velocities) {
        int n = positions.length * velocities.length;
        double[] x = IntStream.range(0, n).mapToDouble(k -> positions[k % positions.length]).toArray();
        double[] v = IntStream.range(0, n).mapToDouble(k -> velocities[k / positions.length]).toArray();
        return new VectorField(x, v, new double[n]);
    }
}
