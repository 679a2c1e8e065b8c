package deSolvers.implicit;

import deSolvers.FiniteCheck;
import java.util.Locale;

/**
 * Newton's method, damped by Deuflhard's natural monotonicity test: a step is taken only as far as the correction that
 * the <i>same</i> matrix would ask for next is smaller. That test does not depend on the units of the equations. A
 * correction that has become a hundredth of the one before is good enough with the old matrix; otherwise the matrix is
 * set up anew.
 */
final class Newton {
    /** The largest last correction, relative to the unknowns, that counts as converged. */
    static final double TOLERANCE = 1e-10;
    /** Corrections after convergence go on as long as they shrink well, down to here: rounding. */
    private static final double POLISHED = 1e-15;
    /** An old matrix is kept while it shrinks the correction this much: two digits for one evaluation. */
    private static final double GOOD_CONTRACTION = 0.01;
    private static final int MOST_ITERATIONS = 50;
    private static final double SMALLEST_DAMPING = 1.0 / 256;
    private static final int MOST_DESCENTS = 200;
    private static final int MOST_HALVINGS = 40;
    /** Entries smaller than this part of the largest are judged as if they were as large as that. */
    private static final double SMALL_ENTRY = 1e-3;

    private static final double SMALLEST_UNSCALED = 1e-100;
    private static final double LARGEST_UNSCALED = 1e100;

    private final ImplicitWork.Counter work;
    private double[] residual = {};
    private double[] correction = {};
    private double[] nextCorrection = {};
    private double[] trial = {};
    private double[] first = {};
    private double[] floor = {};
    private double[] reached = {};
    private double lastSize;
    private int iterations;

    Newton(ImplicitWork.Counter work) {
        this.work = work;
    }

    /**
     * Iterates from the guess in u.
     *
     * @param scale how large the unknowns were when the step began: what rounding and convergence are measured by, with u
     * @return whether it converged; u then holds the solution
     */
    boolean solve(NewtonProblem problem, double[] u, double[] scale) {
        fit(problem.size());
        int n = u.length;
        System.arraycopy(scale, 0, first, 0, n);
        iterations = 0;
        lastSize = Double.POSITIVE_INFINITY;
        problem.evaluate(u, residual);
        if (isZero(residual)) {
            return true;
        }
        if (FiniteCheck.firstNonFinite(residual) >= 0) {
            return false;
        }
        boolean haveCorrection = false;
        double size = 0;
        while (iterations < MOST_ITERATIONS) {
            iterations++;
            work.newtonIterations++;
            if (!haveCorrection) {
                problem.linearise(u);
                if (!correct(problem, correction)) {
                    return false;
                }
                size = size(correction, u);
                lastSize = size;
                if (size == Double.POSITIVE_INFINITY) {
                    return false;
                }
            }
            double damping = 1;
            double next;
            while (true) {
                for (int i = 0; i < n; i++) {
                    trial[i] = u[i] + damping * correction[i];
                }
                problem.evaluate(trial, residual);
                problem.rounding(trial, floor);
                if (damping == 1 && isBelow(residual, floor)) {
                    System.arraycopy(trial, 0, u, 0, n);
                    return true;
                }
                next = FiniteCheck.firstNonFinite(residual) < 0 && correct(problem, nextCorrection)
                        ? size(nextCorrection, trial) : Double.POSITIVE_INFINITY;
                if (next <= (1 - damping / 4) * size) {
                    break;
                }
                if (size <= TOLERANCE) {
                    return true;                        // no correction improves it any more: rounding
                }
                damping /= 2;
                if (damping < SMALLEST_DAMPING) {
                    return false;
                }
            }
            System.arraycopy(trial, 0, u, 0, n);
            haveCorrection = damping == 1 && next <= GOOD_CONTRACTION * size;
            if (damping == 1 && (next <= POLISHED || next <= TOLERANCE && !haveCorrection)) {
                for (int i = 0; i < n; i++) {
                    u[i] += nextCorrection[i];
                }
                return true;
            }
            if (haveCorrection) {
                double[] swap = correction;
                correction = nextCorrection;
                nextCorrection = swap;
                size = next;
                lastSize = size;
            }
        }
        return false;
    }

    /**
     * Looks for the solution where Newton's method found no way: a mechanical system's equation says that an energy is least
     * there. Corrections by a definite matrix go down in that energy, whose slope along them is the residual's product with
     * the correction; they are taken as far as the slope does not turn up again by much. Newton's method itself takes over as
     * soon as it converges, so that the solution is the exact one.
     *
     * @return whether it converged; false also where the problem has no definite matrix
     */
    boolean descend(NewtonProblem problem, double[] u, double[] scale) {
        int all = 0;
        double goal = 1e-1;
        problem.evaluate(u, residual);
        for (int i = 0; i < MOST_DESCENTS; i++) {
            all++;
            work.newtonIterations++;
            if (!problem.lineariseDefinite(u) || !correct(problem, correction)) {
                return false;
            }
            double size = size(correction, u);
            if (size < goal) {
                System.arraycopy(u, 0, reached, 0, u.length);
                if (solve(problem, u, scale)) {
                    return true;
                }
                System.arraycopy(reached, 0, u, 0, u.length);
                problem.evaluate(u, residual);
                problem.lineariseDefinite(u);
                if (!correct(problem, correction)) {
                    return false;
                }
                goal = size / 10;
            }
            if (!goDown(problem, u)) {
                iterations = all;
                return false;
            }
        }
        iterations = all;
        return false;
    }

    /** Takes the correction, or the part of it up to where the slope is about flat. Leaves the residual of the new u. */
    private boolean goDown(NewtonProblem problem, double[] u) {
        double slope = Gmres.dot(residual, correction);
        double part = 1;
        for (int attempt = 0; attempt < MOST_HALVINGS && slope > 0; attempt++) {
            for (int i = 0; i < u.length; i++) {
                trial[i] = u[i] + part * correction[i];
            }
            problem.evaluate(trial, residual);
            double there = Gmres.dot(residual, correction);
            if (there >= -0.5 * slope) {
                System.arraycopy(trial, 0, u, 0, u.length);
                return true;
            }
            double secant = there < 0 ? slope / (slope - there) : 0;
            part *= Math.max(0.1, Math.min(0.5, secant));
        }
        return false;
    }

    /** One correction, whatever it leaves: the linearised equation. */
    boolean solveLinearised(NewtonProblem problem, double[] u) {
        fit(problem.size());
        iterations = 1;
        work.newtonIterations++;
        lastSize = Double.POSITIVE_INFINITY;
        problem.evaluate(u, residual);
        if (isZero(residual)) {
            return true;
        }
        if (FiniteCheck.firstNonFinite(residual) >= 0) {
            return false;
        }
        problem.linearise(u);
        if (!correct(problem, correction)) {
            return false;
        }
        for (int i = 0; i < u.length; i++) {
            u[i] += correction[i];
        }
        return true;
    }

    /** A residual whose square would under- or overflow is scaled for the linear solver. */
    private boolean correct(NewtonProblem problem, double[] result) {
        double largest = 0;
        for (double r : residual) {
            largest = Math.max(largest, Math.abs(r));
        }
        if (largest > SMALLEST_UNSCALED && largest < LARGEST_UNSCALED || largest == 0) {
            return problem.correct(residual, result);
        }
        for (int i = 0; i < residual.length; i++) {
            residual[i] /= largest;
        }
        boolean solved = problem.correct(residual, result);
        for (int i = 0; i < residual.length; i++) {
            residual[i] *= largest;
            result[i] *= largest;
        }
        return solved;
    }

    /** What the last failure looked like, for a message. */
    String describeFailure() {
        double largest = 0;
        for (double r : residual) {
            largest = Math.max(largest, Math.abs(r));
        }
        return String.format(Locale.ROOT, "Newton's iteration did not converge: after %d iterations the correction is %.2g"
                + " of the unknowns (limit %.0e) and the largest residual %.2g", iterations, lastSize, TOLERANCE, largest);
    }

    /** The largest entry of a correction relative to the unknown that it corrects; infinite where that leaves the numbers. */
    private double size(double[] correction, double[] u) {
        double largest = 0;
        for (int i = 0; i < u.length; i++) {
            double magnitude = Math.max(Math.abs(u[i]), Math.abs(u[i] + correction[i]));
            largest = Math.max(largest, Math.max(magnitude, Math.abs(first[i])));
        }
        if (!(largest <= Double.MAX_VALUE)) {
            return Double.POSITIVE_INFINITY;            // nothing is small beside a number that is none
        }
        double size = 0;
        for (int i = 0; i < u.length; i++) {
            if (correction[i] != 0) {
                double magnitude = Math.max(Math.abs(u[i]), Math.abs(u[i] + correction[i]));
                magnitude = Math.max(Math.max(magnitude, Math.abs(first[i])), SMALL_ENTRY * largest);
                size = Math.max(size, Math.abs(correction[i]) / magnitude);
            }
        }
        return size;
    }

    private static boolean isZero(double[] values) {
        for (double value : values) {
            if (value != 0) {
                return false;
            }
        }
        return true;
    }

    private static boolean isBelow(double[] values, double[] limits) {
        for (int i = 0; i < values.length; i++) {
            if (!(Math.abs(values[i]) <= limits[i])) {
                return false;
            }
        }
        return true;
    }

    private void fit(int n) {
        if (residual.length != n) {
            residual = new double[n];
            correction = new double[n];
            nextCorrection = new double[n];
            trial = new double[n];
            first = new double[n];
            floor = new double[n];
            reached = new double[n];
        }
    }
}
