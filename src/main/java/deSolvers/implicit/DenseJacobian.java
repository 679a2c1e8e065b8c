package deSolvers.implicit;

import deSolvers.StepTransaction;
import deSolvers.linear.SolverWork;

/**
 * The Jacobian J = df/ds as a full matrix: column by column by forward differences, at one evaluation each.
 */
final class DenseJacobian {
    /** Half the digits: the best balance of rounding against curvature in a forward difference. */
    static final double ROOT_EPSILON = Math.sqrt(Math.ulp(1.0));
    /** An entry that is small and does not move is varied as if it were this part of the largest entry. */
    static final double SMALL_ENTRY = 1e-5;

    /** Smaller differences would lose their digits to underflow. */
    private static final double SMALLEST_DELTA = 1e-290;

    private final SolverWork work;
    private double[] varied = {};
    private double[] column = {};

    DenseJacobian(SolverWork work) {
        this.work = work;
    }

    /**
     * Computes J at a state and the source's present time. Leaves the source at a state near it.
     *
     * @param source   evaluates f
     * @param state    the state at which J is computed
     * @param dSdt     f at that state
     * @param h        a step (s) that tells how far an entry at 0 may be expected to move
     * @param fine     whether to vary an entry that is far smaller than others by a part of itself: it may be a sum of
     *                 large entries that cancel, where less than a part of the largest is lost to round-off; or f may
     *                 bend there
     * @param jacobian receives J, n x n by rows
     */
    void compute(StepTransaction source, double[] state, double[] dSdt, double h, boolean fine, double[] jacobian) {
        int n = state.length;
        if (varied.length != n) {
            varied = new double[n];
            column = new double[n];
        }
        work.jacobians++;
        double largest = 0;
        for (double s : state) {
            largest = Math.max(largest, Math.abs(s));
        }
        System.arraycopy(state, 0, varied, 0, n);
        for (int j = 0; j < n; j++) {
            double scale = Math.abs(state[j]);
            if (!fine || scale == 0) {
                scale = Math.max(scale, Math.max(Math.abs(h * dSdt[j]), SMALL_ENTRY * largest));
            }
            if (scale == 0) {
                scale = 1;
            }
            varied[j] = state[j] + Math.copySign(Math.max(ROOT_EPSILON * scale, SMALLEST_DELTA), h * dSdt[j]);
            double delta = varied[j] - state[j];        // as rounded, so that the difference is exact
            source.setState(varied);
            source.getStateDerivative(column);
            for (int i = 0; i < n; i++) {
                jacobian[i * n + j] = (column[i] - dSdt[i]) / delta;
            }
            varied[j] = state[j];
        }
    }
}
