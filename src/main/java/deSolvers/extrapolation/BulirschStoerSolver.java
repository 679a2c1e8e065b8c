package deSolvers.extrapolation;

import deSolvers.StepTransaction;
import deSolvers.adaptive.AdaptiveSolver;

/**
 * The Bulirsch-Stoer extrapolation method (also Gragg-Bulirsch-Stoer), one of the slides' "high-strung racehorses". It
 * covers the same stretch by the modified midpoint method with n<sub>0</sub>, n<sub>1</sub>, ... = 2, 6, 10, 14, ...
 * substeps, and extrapolates the results to infinitely many.
 * <pre>
 *   T_00
 *   T_10  T_11              T_jk = T_j,k-1 + (T_j,k-1 - T_j-1,k-1) / ((n_j / n_j-k)^2 - 1)
 *   T_20  T_21  T_22        the last entry of a line is the result, the last two differ by its error
 * </pre>
 * The number of lines and the length of the stretch are chosen for the least work.
 *
 * <p>If the stretch is too long for a fast component of the solution, the last two entries may agree by chance although
 * both are far too large. For s' = lambda s with five lines, at h lambda = -9.15, both are 15 times the starting value,
 * while the solution has almost vanished. A second table therefore extrapolates the change of every T_j0 by Gragg's
 * smoothing, which should tend to 0. If the first table converges, the rest is about a third of the error estimate at
 * h omega = 1, and less in shorter stretches; if not, on the negative real axis, it is larger than the result itself.
 * A quarter of this rest counts as an error too. It costs no evaluation.
 *
 * <p><b>Order</b> variable, 2 k + 2 for k + 1 lines, up to 18.<br>
 * <b>Evaluations</b> 2 + 6 + 10 + ... a sub-step, and 1 at its beginning.<br>
 * <b>Stability</b> that of an explicit method, with another R(z) for every number of lines: 2 to 9 are stable for h
 * |lambda| &le; 5.02, 7.36, 6.39, 7.27, 8.25, 9.26, 10.29, 11.33 on the negative real axis. A component that is too
 * fast for the stretches, and has decayed, may grow again to many times its tolerance (25 were measured, 19 with {@code
 * dormand-prince}). An undamped vibration may grow by its tolerance in every stretch: with 1e-3 some grew 4.7-fold in
 * 640 periods. On a stiff system its sub-steps are very short, at a higher cost than with {@code dormand-prince}.<br>
 * <b>When to use</b> smooth motion to high accuracy, errors of 1e-8 and below; not where bounces or contacts interrupt
 * the motion, since it needs long stretches to pay; nor for errors of 1e-4 or more, for which {@code dormand-prince} is
 * cheaper.<br>
 * <b>Source</b> R. Bulirsch, J. Stoer, Numer. Math. 8 (1966) 1-13; W. B. Gragg, SIAM J. Numer. Anal. 2 (1965) 384-403;
 * P. Deuflhard, Numer. Math. 41 (1983) 399-422 (order and step); the check by the smoothing is our own.
 */
public final class BulirschStoerSolver extends AdaptiveSolver {
    private final OrderControl control = new OrderControl();
    private final ModifiedMidpoint midpoint = new ModifiedMidpoint();
    private final ExtrapolationTable results = new ExtrapolationTable();
    private final ExtrapolationTable smoothings = new ExtrapolationTable();
    private double[] error = {};

    /** With the tolerances {@value #RELATIVE_TOLERANCE} and {@value #ABSOLUTE_TOLERANCE}. */
    public BulirschStoerSolver() {
        this(RELATIVE_TOLERANCE, ABSOLUTE_TOLERANCE);
    }

    /**
     * @param relativeTolerance error allowed for an entry of the state in one sub-step, relative to its size
     * @param absoluteTolerance error allowed besides, in the entry's unit
     * @throws IllegalArgumentException if one of them is negative or not finite, or both are 0
     */
    public BulirschStoerSolver(double relativeTolerance, double absoluteTolerance) {
        super(relativeTolerance, absoluteTolerance);
    }

    @Override
    protected void resize(int n) {
        midpoint.resize(n);
        results.resize(n);
        smoothings.resize(n);
        error = new double[n];
    }

    @Override
    protected void restart() {
        control.restart(getTolerance().getRelative());
    }

    @Override
    protected double attempt(StepTransaction source, double[] state, double[] slope, double offset, double h,
                             double[] newState) {
        OrderControl.Verdict verdict = OrderControl.Verdict.CONTINUE;
        double ratio = Double.POSITIVE_INFINITY;
        midpoint.begin(state, slope, offset, h);
        for (int j = 0; verdict == OrderControl.Verdict.CONTINUE; j++) {
            midpoint.cover(source, OrderControl.substeps(j), results.begin(j), smoothings.begin(j));
            results.extrapolate(j);
            smoothings.extrapolate(j);
            if (j > 0) {
                estimate(results, smoothings, error);
                ratio = getTolerance().ratio(error, state, results.result());
                verdict = control.column(j, ratio, Math.abs(h));
            }
        }
        System.arraycopy(results.result(), 0, newState, 0, newState.length);
        return verdict == OrderControl.Verdict.ACCEPT ? ratio : Double.POSITIVE_INFINITY;
    }

    /**
     * The error estimate: the change by the last column, or a quarter of the extrapolated smoothing, whichever is
     * larger.
     */
    static void estimate(ExtrapolationTable results, ExtrapolationTable smoothings, double[] error) {
        double[] correction = results.getCorrection();
        double[] smoothing = smoothings.result();
        for (int i = 0; i < error.length; i++) {
            error[i] = Math.max(Math.abs(correction[i]), Math.abs(smoothing[i]) / 4);
        }
    }

    @Override
    protected double nextSubStep(double h, double error) {
        return control.getNext();
    }

    @Override
    protected int errorExponent() {
        return control.targetExponent();
    }
}
