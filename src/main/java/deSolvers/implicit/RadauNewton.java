package deSolvers.implicit;

import static deSolvers.implicit.RadauTableau.MU;
import static deSolvers.implicit.RadauTableau.MU_IM;
import static deSolvers.implicit.RadauTableau.MU_RE;

import deSolvers.FiniteCheck;
import deSolvers.GuardedStep;
import deSolvers.adaptive.Tolerance;

/**
 * The simplified Newton iteration for the three stages z<sub>i</sub> = g<sub>i</sub> - s of a sub-step, in the variables
 * w = T<sup>-1</sup> z in which it falls apart into a real and a complex system. It stops when the next corrections will
 * add no more than a hundredth of the tolerance, or less, and gives up as soon as it sees that it will not get there.
 */
final class RadauNewton {
    static final int MOST_ITERATIONS = 6;
    /** Of the tolerance: what may be left when the iteration stops; less where the tolerance is strict and steps are many. */
    private static final double MOST_LEFT = 0.01;

    private final ImplicitWork.Counter work;
    private final Tolerance tolerance;
    private final double[][] w;
    private final double[][] f;
    private final double[][] split;                     // T^-1 f
    private final double[] trial;
    private final double[] right;
    private final double[] correction;
    private final double[] complexRight;
    private final double[] complexCorrection;
    private final double[] change;
    private int iterations;
    private double rate;

    RadauNewton(ImplicitWork.Counter work, Tolerance tolerance, int n) {
        this.work = work;
        this.tolerance = tolerance;
        w = new double[3][n];
        f = new double[3][n];
        split = new double[3][n];
        trial = new double[n];
        right = new double[n];
        correction = new double[n];
        complexRight = new double[2 * n];
        complexCorrection = new double[2 * n];
        change = new double[n];
    }

    /**
     * Iterates.
     *
     * @param z a guess for the stages; receives them
     * @return whether it converged
     */
    boolean solve(GuardedStep source, RadauSystems systems, double[] state, double offset, double h, double[][] z) {
        int n = state.length;
        double enough = Math.max(Math.min(MOST_LEFT, Math.sqrt(tolerance.relative())),
                10 * Math.ulp(1.0) * tolerance.size(state, state));     // no less than rounding
        RadauTableau.transform(true, z, w);
        double sizeBefore = 0;
        rate = 0;
        for (iterations = 1; iterations <= MOST_ITERATIONS; iterations++) {
            work.newtonIterations++;
            if (!evaluate(source, state, offset, h, z) || !correct(systems, h)) {
                return false;
            }
            double size = 0;
            for (int k = 0; k < 3; k++) {
                for (int i = 0; i < n; i++) {
                    change[i] = k == 0 ? correction[i] : complexCorrection[2 * i + k - 1];
                    w[k][i] += change[i];
                }
                size = Math.max(size, tolerance.size(change, state));
            }
            if (!(size <= Double.MAX_VALUE)) {
                return false;
            }
            RadauTableau.transform(false, w, z);
            if (size == 0) {
                return true;
            }
            if (iterations > 1) {
                rate = size / sizeBefore;
                if (rate < 1 && rate / (1 - rate) * size < enough) {
                    return true;
                }
                double atBest = power(rate, MOST_ITERATIONS - iterations) / (1 - rate) * size;
                if (rate >= 1 || atBest > enough) {
                    return false;
                }
            }
            sizeBefore = size;
        }
        return false;
    }

    private static double power(double base, int exponent) {
        double result = 1;
        for (int i = 0; i < exponent; i++) {
            result *= base;
        }
        return result;
    }

    /** The derivatives at the stages, at (s + z_i, t + c_i h); false if one is not finite. */
    private boolean evaluate(GuardedStep source, double[] state, double offset, double h, double[][] z) {
        for (int k = 0; k < 3; k++) {
            for (int i = 0; i < state.length; i++) {
                trial[i] = state[i] + z[k][i];
            }
            source.setState(trial);
            source.setOffset(offset + RadauTableau.c(k) * h);
            source.getStateDerivative(f[k]);
            if (FiniteCheck.firstNonFinite(f[k]) >= 0) {
                return false;
            }
        }
        return true;
    }

    /** (mu - h J) correction = h (T^-1 f) - mu w, for the real and the complex variable. */
    private boolean correct(RadauSystems systems, double h) {
        RadauTableau.transform(true, f, split);
        for (int i = 0; i < right.length; i++) {
            right[i] = h * split[0][i] - MU * w[0][i];
            complexRight[2 * i] = h * split[1][i] - (MU_RE * w[1][i] - MU_IM * w[2][i]);
            complexRight[2 * i + 1] = h * split[2][i] - (MU_RE * w[2][i] + MU_IM * w[1][i]);
        }
        return systems.solveReal(right, correction) && systems.solveComplex(complexRight, complexCorrection);
    }

    /** How many iterations the last solution took. */
    int iterations() {
        return iterations;
    }

    /** By how much the last correction was smaller than the one before; 0 after a single one. */
    double rate() {
        return rate;
    }
}
