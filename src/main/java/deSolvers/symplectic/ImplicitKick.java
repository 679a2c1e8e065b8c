package deSolvers.symplectic;

import deSolvers.StepTransaction;

/**
 * A kick with the acceleration at its own end, v = v0 + h a(x, v, t), solved for v by fixed-point iteration. With the
 * acceleration at v0 instead, a step would no longer be the mirror image of itself, and its order would fall to 1.
 */
final class ImplicitKick {
    /** Relative to the velocities: some hundred times the round-off. */
    private static final double TOLERANCE = 1e-13;
    /** Relative to the largest position: how far round-off may move the end of the step. */
    private static final double ROUND_OFF = 0x1p-50;
    private static final int MOST_ITERATIONS = 100;

    private double[] before = {};                       // (x, v0)
    private double change;                              // the largest change of a velocity in the last iteration

    /**
     * Solves the equation.
     *
     * @param source     the step, its clock at the kick's time
     * @param s          holds (x, v0); receives (x, v)
     * @param guess      an acceleration nearby
     * @param velocities the indices of the velocity entries
     * @param d          the distance in the array from a position to its velocity
     * @param h          the kick's length (s)
     * @param a          receives the acceleration at (x, v)
     */
    void solve(StepTransaction source, double[] s, double[] guess, int[] velocities, int d, double h,
               double[] a) {
        if (before.length != s.length) {
            before = new double[s.length];
        }
        System.arraycopy(s, 0, before, 0, s.length);
        kick(s, guess, velocities, h);
        double scale = largest(before, velocities, 0);
        for (int iteration = 0; iteration < MOST_ITERATIONS; iteration++) {
            double last = change;
            source.getStateDerivative(s, a);            // at (x, v, t) with the latest v
            kick(s, a, velocities, h);
            if (iteration == 0) {
                source.requireFinite(a);
                scale += change;
            }
            if (!(change <= Double.MAX_VALUE)) {
                break;                                  // diverged until the source overflows: not the source's fault
            }
            if (change <= TOLERANCE * Math.max(scale, Double.MIN_NORMAL)) {     // smaller numbers have fewer digits
                return;
            }
            if (iteration > 0 && change >= last
                    && change * Math.abs(h) <= ROUND_OFF * largest(s, velocities, d)) {
                return;                                 // near rest, where large forces cancel, only round-off is left
            }
        }
        throw source.failure(-1, "the velocity at the end of the step did not converge in " + MOST_ITERATIONS
                + " iterations (last change " + change + " of " + scale + "); drag or spring damping is too stiff for"
                + " this deltaT: take a smaller one or an implicit solver");
    }

    /** v = v0 + h a; notes the largest change, NaN if one is. */
    private void kick(double[] s, double[] a, int[] velocities, double h) {
        double largest = 0;
        for (int v : velocities) {
            double kicked = before[v] + h * a[v];
            largest = larger(Math.abs(kicked - s[v]), largest);
            s[v] = kicked;
        }
        change = largest;
    }

    /** The largest velocity by its size, or the largest position with the shift d; NaN if one is. */
    private static double largest(double[] s, int[] velocities, int shift) {
        double largest = 0;
        for (int v : velocities) {
            largest = larger(Math.abs(s[v - shift]), largest);
        }
        return largest;
    }

    /** The larger one, NaN if one is. */
    private static double larger(double size, double largest) {
        return size <= largest ? largest : Double.isNaN(largest) ? largest : size;
    }
}
