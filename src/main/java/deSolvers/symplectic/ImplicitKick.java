package deSolvers.symplectic;

import deSolvers.SecondOrderStateSource;
import deSolvers.StepTransaction;
import deSolvers.text.Digits;

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
     * @param source the step, its clock at the kick's time
     * @param s      holds (x, v0); receives (x, v)
     * @param guess  an acceleration nearby
     * @param d      the positions, and the velocities, in a block
     * @param h      the kick's length (s)
     * @param a      receives the acceleration at (x, v)
     */
    void solve(StepTransaction source, double[] s, double[] guess, int d, double h, double[] a) {
        if (before.length != s.length) {
            before = new double[s.length];
        }
        System.arraycopy(s, 0, before, 0, s.length);
        kick(s, guess, d, h);
        double scale = largest(before, d, d);
        for (int iteration = 0; iteration < MOST_ITERATIONS; iteration++) {
            double last = change;
            source.getStateDerivative(s, a);            // at (x, v, t) with the latest v
            kick(s, a, d, h);
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
            if (iteration > 0 && change >= last && (change * Math.abs(h) <= ROUND_OFF * largest(s, 0, d)
                    || change <= ROUND_OFF * Math.abs(h) * largestTerm(source))) {
                return;                                 // near rest, where large forces cancel, only round-off is left
            }
        }
        throw source.failure(-1, "the velocity at the end of the step did not converge in " + MOST_ITERATIONS
                + " iterations", "the last change is " + Digits.few(change) + " of " + Digits.few(scale)
                + "; a force that depends on the velocity, as drag or damping, is too stiff for this deltaT: take a"
                + " smaller one or an implicit solver");
    }

    private static double largestTerm(StepTransaction source) {
        return source.getClient() instanceof SecondOrderStateSource client ? client.getLargestTerm() : 0;
    }

    /** v = v0 + h a; notes the largest change, NaN if one is. */
    private void kick(double[] s, double[] a, int d, double h) {
        double largest = 0;
        for (int block = d; block < s.length; block += 2 * d) {
            for (int v = block; v < block + d; v++) {
                double kicked = before[v] + h * a[v];
                largest = Math.max(largest, Math.abs(kicked - s[v]));
                s[v] = kicked;
            }
        }
        change = largest;
    }

    /** The largest size among the positions, from entry 0 on, or the velocities, from entry d on; NaN if one is. */
    private static double largest(double[] s, int first, int d) {
        double largest = 0;
        for (int block = first; block < s.length; block += 2 * d) {
            for (int i = block; i < block + d; i++) {
                largest = Math.max(largest, Math.abs(s[i]));
            }
        }
        return largest;
    }
}
