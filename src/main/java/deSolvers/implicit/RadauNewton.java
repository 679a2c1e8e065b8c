package deSolvers.implicit;

import static deSolvers.implicit.RadauTableau.MU;
import static deSolvers.implicit.RadauTableau.MU_IM;
import static deSolvers.implicit.RadauTableau.MU_RE;
import static deSolvers.implicit.RadauTableau.MU_SQUARE;

import deSolvers.StepTransaction;
import deSolvers.adaptive.Tolerance;
import deSolvers.linear.SolverWork;

/**
 * The simplified Newton iteration for the three stages z<sub>i</sub> = g<sub>i</sub> - s of a sub-step, in the
 * variables w = T<sup>-1</sup> z in which it falls apart into a real and a complex system. It stops when the next
 * corrections will add no more than a hundredth of the tolerance, or less, and gives up as soon as it sees that it will
 * not get there.
 */
final class RadauNewton {
    static final int MOST_ITERATIONS = 6;
    /**
     * The largest remaining error when the iteration stops, as a fraction of the tolerance; less if the tolerance is
     * strict.
     */
    private static final double MOST_LEFT = 0.01;

    /** For one correction: so exact that the iteration converges as with exact solutions. */
    static final double LINEAR_TOLERANCE = 1e-4;

    private final SolverWork work;
    private final Tolerance tolerance;
    private final double[][] w;
    private final double[][] f;
    private final double[][] split;                     // T^-1 f
    private final double[] trial;
    private final double[] right;
    private final double[][] complexRight;
    private double[][] change;                          // of w: the last correction, one real and one complex vector
    private final double[][] complexChange = new double[2][];
    private double[][] changeBefore;
    private final double[] magnitude;                   // how large each entry is within the sub-step
    private int iterations;
    private double rate;

    RadauNewton(SolverWork work, Tolerance tolerance, int n) {
        this.work = work;
        this.tolerance = tolerance;
        w = new double[3][n];
        f = new double[3][n];
        split = new double[3][n];
        trial = new double[n];
        right = new double[n];
        complexRight = new double[2][n];
        change = new double[3][n];
        changeBefore = new double[3][n];
        magnitude = new double[n];
    }

    /**
     * Iterates.
     *
     * @param z a guess for the stages; receives them
     * @return whether it converged
     */
    boolean solve(StepTransaction source, ShiftedJacobian jacobian, double[] state, double offset, double h,
            double[][] z) {
        RadauTableau.transform(true, z, w);
        rate = 0;
        for (iterations = 1; iterations <= MOST_ITERATIONS; iterations++) {
            work.newtonIterations++;
            if (!evaluate(source, state, offset, h, z) || !correct(source, jacobian, offset, h)) {
                return false;
            }
            for (int i = 0; i < state.length; i++) {
                for (int k = 0; k < 3; k++) {
                    w[k][i] += change[k][i];
                }
            }
            RadauTableau.transform(false, w, z);
            measure(state, z);
            double size = size(change);
            if (!(size <= Double.MAX_VALUE)) {
                return false;
            }
            if (size == 0) {
                return true;
            }
            if (iterations > 1) {
                double enough = enough();
                rate = size / size(changeBefore);       // both by the same measure, which has grown with what diverges
                if (rate < 1 && rate / (1 - rate) * size < enough) {
                    return true;
                }
                double atBest = power(rate, MOST_ITERATIONS - iterations) / (1 - rate) * size;
                if (rate >= 1 || atBest > enough) {
                    return false;
                }
            }
        }
        return false;
    }

    /**
     * Finds the largest size of each entry within the sub-step. Corrections are measured by it, like errors, so that an
     * entry that begins at 0 need not be exact where there is no absolute tolerance.
     */
    private void measure(double[] state, double[][] z) {
        for (int i = 0; i < state.length; i++) {
            double moved = Math.max(Math.abs(state[i] + z[0][i]), Math.abs(state[i] + z[1][i]));
            magnitude[i] = Math.max(Math.max(Math.abs(state[i]), Math.abs(state[i] + z[2][i])), moved);
        }
    }

    /** The largest of the corrections of the three variables, in units of the tolerance. */
    private double size(double[][] corrections) {
        double size = 0;
        for (double[] values : corrections) {
            size = Math.max(size, tolerance.size(values, magnitude));
        }
        return size;
    }

    /**
     * The largest remaining correction at which the iteration stops, by the entry whose tolerance is strictest compared
     * with its size; at least round-off.
     */
    private double enough() {
        double strictest = tolerance.size(magnitude, magnitude);
        return Math.max(Math.min(MOST_LEFT, Math.sqrt(1 / strictest)), 10 * Math.ulp(1.0) * strictest);
    }

    private static double power(double base, int exponent) {
        double result = 1;
        for (int i = 0; i < exponent; i++) {
            result *= base;
        }
        return result;
    }

    /** The derivatives at the stages, at (s + z_i, t + c_i h); false if one is not finite. */
    private boolean evaluate(StepTransaction source, double[] state, double offset, double h, double[][] z) {
        for (int k = 0; k < 3; k++) {
            for (int i = 0; i < state.length; i++) {
                trial[i] = state[i] + z[k][i];
            }
            source.setState(trial);
            source.setOffset(offset + RadauTableau.c(k) * h);
            source.getStateDerivative(f[k]);
            if (StepTransaction.firstNonFinite(f[k]) >= 0) {
                return false;
            }
        }
        return true;
    }

    /** (mu - h J) change = h (T^-1 f) - mu w, divided by mu, for the real and the complex variable. */
    private boolean correct(StepTransaction source, ShiftedJacobian jacobian, double offset, double h) {
        RadauTableau.transform(true, f, split);
        source.setOffset(offset);                       // where the Jacobian is
        for (int i = 0; i < right.length; i++) {
            right[i] = h / MU * split[0][i] - w[0][i];
            complexRight[0][i] = h / MU_SQUARE * (MU_RE * split[1][i] + MU_IM * split[2][i]) - w[1][i];
            complexRight[1][i] = h / MU_SQUARE * (MU_RE * split[2][i] - MU_IM * split[1][i]) - w[2][i];
        }
        double[][] oldest = changeBefore;
        changeBefore = change;
        change = oldest;
        complexChange[0] = change[1];
        complexChange[1] = change[2];
        return jacobian.solve(right, change[0], LINEAR_TOLERANCE)
                && jacobian.solveComplex(complexRight, complexChange, LINEAR_TOLERANCE);
    }

    /** The number of iterations of the last solution. */
    int getIterations() {
        return iterations;
    }

    /** The ratio of the last correction to the one before; 0 after a single one. */
    double getRate() {
        return rate;
    }
}
