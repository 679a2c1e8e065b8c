package deSolvers.extrapolation;

import deSolvers.GuardedStep;

/**
 * Gragg's modified midpoint method over a stretch H in n substeps h = H/n:
 * <pre>
 *   y_0 = s,   y_1 = s + h f_0,   y_{i+1} = y_{i-1} + 2 h f_i,   result = (y_{n-1} + y_n + h f_n) / 2
 * </pre>
 * The result is a mean of y_n and what f_n leads to, which smooths the zigzag between even and odd y.
 * It can keep y at the middle and all f, from which the states in between are found.
 */
final class ModifiedMidpoint {
    private double[] last = {};                         // y_{i-1}
    private double[] present = {};                      // y_i
    private double[] dSdt = {};

    void resize(int n) {
        last = new double[n];
        present = new double[n];
        dSdt = new double[n];
    }

    /**
     * @param slope     f_0
     * @param offset    where the stretch begins, from the beginning of the step (s)
     * @param length    H (s)
     * @param n         substeps; even
     * @param record    receives y_{n/2} and f_0 ... f_n, or does not
     * @param result    receives s(H), with an error in even powers of 1/n
     * @param smoothing receives result - y_n, in even powers of 1/n too
     */
    void cover(GuardedStep source, double[] state, double[] slope, double offset, double length, int n, Record record,
               double[] result, double[] smoothing) {
        double h = length / n;
        System.arraycopy(state, 0, last, 0, state.length);
        for (int i = 0; i < state.length; i++) {
            present[i] = state[i] + h * slope[i];
        }
        record.slope(0, slope);
        for (int step = 1; step <= n; step++) {
            source.setState(present);
            source.setOffset(step == n ? offset + length : offset + step * h);
            source.getStateDerivative(dSdt);            // at (y_i, t + i h)
            record.slope(step, dSdt);
            if (step == n / 2) {
                record.middle(present);
            }
            if (step < n) {
                for (int i = 0; i < dSdt.length; i++) {
                    double next = last[i] + 2 * h * dSdt[i];
                    last[i] = present[i];
                    present[i] = next;
                }
            }
        }
        for (int i = 0; i < result.length; i++) {
            double ahead = last[i] + h * dSdt[i];
            result[i] = (ahead + present[i]) / 2;
            smoothing[i] = (ahead - present[i]) / 2;
        }
    }

    /** What is kept of one coverage for the states in between. */
    interface Record {
        /** A state that is known at the middle; copied. */
        void middle(double[] state);

        /** A derivative at substep i, 0 to n; copied. */
        void slope(int i, double[] dSdt);
    }
}
