package deSolvers.implicit;

import deSolvers.DESolverException;
import deSolvers.StepTransaction;
import deSolvers.implicit.ShiftedJacobian.Kind;
import deSolvers.linear.SolverWork;
import deSolvers.text.Digits;
import java.util.Arrays;

/**
 * Newton's method for the equation of all one-stage implicit methods, m = s + g f(m, t), at the source's present time.
 * With the residual r(m) = s + g f(m, t) - m, an iteration solves (I - g J) deltaM = r and adds deltaM to m.
 *
 * <p>The line search adds the largest part of deltaM, at most all of it, at which the slope along deltaM has not turned
 * round by more than half. For particles the slope is that of an energy, whose minimum is the solution; {@link
 * ShiftedJacobian#slope} defines it for other sources. If deltaM does not lead down, or no part of it is acceptable, a
 * variant of J is used that leads down: {@link Kind#CAREFUL}. A small correction that shrinks the next one to a tenth
 * is taken even if it does not lead down: a cloth that is about to buckle has a solution where its energy has a saddle.
 *
 * <p>A correction that has become a hundredth of the one before is good enough with the old matrix; otherwise J is set
 * up anew.
 *
 * <p>The stopping rule: each entry's correction is at most {@value #TOLERANCE} of the entry, or all residuals are
 * round-off of the terms they are sums of. An entry that is itself round-off counts as its round-off / {@value
 * #TOLERANCE}. Corrections that no longer shrink may also be as large as the largest round-off of any position or
 * velocity.
 *
 * <p>Source: P. Deuflhard, <i>Newton Methods for Nonlinear Problems</i>, Springer 2004, sections 2.1 and 3.3; J.
 * Nocedal, S. J. Wright, <i>Numerical Optimization</i>, 2nd ed., Springer 2006, section 3.1.
 */
final class Newton {
    /** The largest last correction, relative to the unknowns, that counts as converged. */
    static final double TOLERANCE = 1e-10;
    /** Corrections that still shrink fast are continued down to this size. */
    private static final double POLISHED = 1e-15;
    /** An old matrix is kept while it shrinks the correction this much: two digits for one evaluation. */
    private static final double GOOD_CONTRACTION = 0.01;
    /** A correction that shrinks less than this with a new matrix is either round-off, or the matrix is poor. */
    private static final double STAGNATION = 0.5;
    /** Corrections below this size may lead to a stationary point of the energy that is not a minimum. */
    private static final double NEAR = 1e-4;
    /** Such corrections have to shrink by this factor. */
    private static final double NEAR_CONTRACTION = 0.1;
    private static final double SMALLEST_PART = 1e-4;
    /** The line search allows the slope to reverse to this fraction of its first value. */
    private static final double MOST_REVERSED = 0.5;
    /**
     * The relative residual of the linear system for one correction; the last correction reduces the rest by this
     * factor again.
     */
    private static final double LINEAR_TOLERANCE = 1e-4;

    private final SolverWork work = new SolverWork();
    private final JacobianChoice choice = new JacobianChoice(work);
    private StepTransaction source;
    private ShiftedJacobian jacobian;
    private double[] start;
    private double g;
    private double[] slope = {};
    private double[] residual = {};
    private double[] correction = {};
    private double[] nextCorrection = {};
    private double[] trial = {};
    private double[] roundOff = {};
    private double size;                                // of the last correction, relative to the unknowns
    private double nextSize;
    private double slope0;                              // along it, where it begins
    private double part;                                // the part of it that was added
    private int iterations;

    /** The work of all steps so far. */
    SolverWork getWork() {
        return work;
    }

    /**
     * Solves the equation.
     *
     * @param source its clock at t
     * @param start  s
     * @param g      g (s)
     * @param m      receives m
     * @throws DESolverException if the iteration does not converge
     */
    void solve(StepTransaction source, double[] start, double g, double[] m) {
        begin(source, start, g, m);
        jacobian.guess(source.getClient(), m);
        evaluate(m);
        source.requireFinite(slope);
        if (!iterate(m)) {
            throw failure();
        }
    }

    /**
     * One correction from s, with spring blocks projected: m = s + (I - g J)<sup>-1</sup> g f(s, t).
     *
     * @param source its clock at t
     * @param start  s
     * @param g      g (s)
     * @param m      receives m
     * @throws DESolverException if the linear system cannot be solved
     */
    void solveLinearised(StepTransaction source, double[] start, double g, double[] m) {
        begin(source, start, g, m);
        evaluate(m);
        source.requireFinite(slope);
        iterations = 1;
        if (!linearise(m, Kind.PROJECTED)) {
            throw failure();
        }
        add(correction, 1, m);
        jacobian.complete(start, g, m);
    }

    private void begin(StepTransaction source, double[] start, double g, double[] m) {
        this.source = source;
        this.start = start;
        this.g = g;
        int n = start.length;
        if (residual.length != n) {
            slope = new double[n];
            residual = new double[n];
            correction = new double[n];
            nextCorrection = new double[n];
            trial = new double[n];
            roundOff = new double[n];
        }
        jacobian = choice.of(source.getClient());
        jacobian.forget();
        System.arraycopy(start, 0, m, 0, n);
        Arrays.fill(roundOff, 0);
    }

    private void evaluate(double[] m) {
        source.setState(m);
        source.getStateDerivative(slope);
        for (int i = 0; i < m.length; i++) {
            residual[i] = start[i] - m[i] + g * slope[i];
        }
    }

    private boolean iterate(double[] m) {
        boolean haveCorrection = false;
        Kind kind = Kind.EXACT;
        for (iterations = 1; iterations <= jacobian.mostIterations(); iterations++) {
            boolean known = kind == Kind.CAREFUL || jacobian.seesSmallEntries(m);
            if (isRoundOff() && known) {
                return true;
            }
            if (!haveCorrection && !linearise(m, kind) || !search(m)) {
                if (kind == Kind.CAREFUL || known && isConverged(size, correction)) {
                    return isConverged(size, correction);       // nothing improves it any more: round-off
                }
                kind = Kind.CAREFUL;
                haveCorrection = false;
                evaluate(m);
                continue;
            }
            boolean stagnates = nextSize > STAGNATION * size;
            if (part == 1 && known && (nextSize <= POLISHED || stagnates && isConverged(nextSize, nextCorrection))) {
                add(nextCorrection, 1, m);
                jacobian.complete(start, g, m);
                return true;
            }
            haveCorrection = part == 1 && nextSize <= GOOD_CONTRACTION * size && nextSize > POLISHED;
            if (haveCorrection) {
                double[] swap = correction;
                correction = nextCorrection;
                nextCorrection = swap;
                size = nextSize;
                slope0 = jacobian.slope(residual, correction, correction);
            } else {
                kind = part == 1 && known && (kind == Kind.CAREFUL || !stagnates) ? Kind.EXACT : Kind.CAREFUL;
            }
        }
        return isRoundOff() || nextSize > STAGNATION * size && isConverged(size, correction);
    }

    private boolean isConverged(double size, double[] correction) {
        return size <= TOLERANCE || size != Double.POSITIVE_INFINITY
                && NewtonUpdate.isRoundOffOfTheLargest(source.getClient(), correction, g, roundOff);
    }

    /** Sets J up at m and computes the correction that it asks for; false if there is none. */
    private boolean linearise(double[] m, Kind kind) {
        work.newtonIterations++;
        size = Double.POSITIVE_INFINITY;
        jacobian.setJacobian(source, m, slope, g, kind);
        if (!jacobian.prepare(g) || !correct(correction)) {
            return false;
        }
        jacobian.terms(m, slope, g, roundOff);
        NewtonUpdate.roundOff(source.getClient(), start, m, roundOff);
        size = NewtonUpdate.size(correction, m, start, roundOff);
        slope0 = jacobian.slope(residual, correction, correction);
        return size != Double.POSITIVE_INFINITY;
    }

    private boolean correct(double[] result) {
        return NewtonUpdate.solve(jacobian, residual, result, LINEAR_TOLERANCE);
    }

    /**
     * Adds as much of the correction as the line search allows, and computes the next one; false if no part will do.
     */
    private boolean search(double[] m) {
        boolean nearSaddle = slope0 < 0 && size <= NEAR;
        for (part = 1; part >= SMALLEST_PART && (slope0 >= 0 || nearSaddle && part == 1);) {
            System.arraycopy(m, 0, trial, 0, m.length);
            add(correction, part, trial);
            jacobian.complete(start, g, trial);
            evaluate(trial);
            boolean solved = StepTransaction.firstNonFinite(residual) < 0 && correct(nextCorrection);
            double turned = solved ? jacobian.slope(residual, nextCorrection, correction) : Double.NEGATIVE_INFINITY;
            nextSize = solved ? NewtonUpdate.size(nextCorrection, trial, start, roundOff) : Double.POSITIVE_INFINITY;
            if (nearSaddle ? nextSize <= NEAR_CONTRACTION * size : turned >= -MOST_REVERSED * slope0) {
                System.arraycopy(trial, 0, m, 0, m.length);
                return true;
            }
            if (isConverged(size, correction)) {
                return false;
            }
            part *= Math.max(0.1, Math.min(0.5, slope0 / (slope0 - turned)));
        }
        return false;
    }

    private static void add(double[] change, double part, double[] m) {
        for (int i = 0; i < m.length; i++) {
            m[i] += part * change[i];
        }
    }

    private boolean isRoundOff() {
        for (int i = 0; i < residual.length; i++) {
            if (!(Math.abs(residual[i]) <= roundOff[i])) {
                return false;
            }
        }
        return true;
    }

    private DESolverException failure() {
        int made = Math.min(iterations, jacobian.mostIterations());
        String cause = size == Double.POSITIVE_INFINITY
                ? "the linear solver failed at Newton's iteration " + made + ": the matrix is singular or not finite,"
                        + " or GMRES did not converge"
                : "Newton's iteration did not converge: after " + made + " iterations the correction is "
                        + Digits.few(size) + " of the unknowns (limit " + Digits.few(TOLERANCE)
                        + ") and the largest residual " + Digits.few(NewtonUpdate.largest(residual));
        return source.failure(-1, cause, "deltaT is probably too large for what the forces do within it");
    }
}
