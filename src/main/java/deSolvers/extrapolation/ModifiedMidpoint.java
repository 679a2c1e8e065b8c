package deSolvers.extrapolation;

import deSolvers.StepTransaction;

/**
 * Gragg's modified midpoint method over a stretch H in n substeps h = H/n:
 * <pre>
 *   y_0 = s,   y_1 = s + h f_0,   y_{i+1} = y_{i-1} + 2 h f_i,   result = (y_{n-1} + y_n + h f_n) / 2
 * </pre>
 * The final average smooths the zigzag between even and odd y (Gragg's smoothing).
 */
final class ModifiedMidpoint {
    private double[] last = {};                         // y_{i-1}
    private double[] present = {};                      // y_i
    private double[] dSdt = {};
    private double[] state = {};
    private double[] slope = {};
    private double offset;
    private double length;

    void resize(int n) {
        last = new double[n];
        present = new double[n];
        dSdt = new double[n];
    }

    /**
     * Sets the stretch to be covered.
     *
     * @param state  s
     * @param slope  f_0
     * @param offset the beginning of the stretch, from that of the step (s)
     * @param length H (s)
     */
    void begin(double[] state, double[] slope, double offset, double length) {
        this.state = state;
        this.slope = slope;
        this.offset = offset;
        this.length = length;
    }

    /**
     * @param n         substeps; even
     * @param result    receives s(H), with an error in even powers of 1/n
     * @param smoothing receives result - y_n, in even powers of 1/n too
     */
    void cover(StepTransaction source, int n, double[] result, double[] smoothing) {
        double h = length / n;
        System.arraycopy(state, 0, last, 0, state.length);
        for (int i = 0; i < state.length; i++) {
            present[i] = state[i] + h * slope[i];
        }
        for (int step = 1; step <= n; step++) {
            source.setState(present);
            source.setOffset(step == n ? offset + length : offset + step * h);
            source.getStateDerivative(dSdt);            // at (y_i, t + i h)
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
}
