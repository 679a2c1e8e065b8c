package deSolvers.implicit;

import deSolvers.linear.Gmres;
import deSolvers.linear.ImplicitWork;
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
    /**
     * A residual is rounding up to so many times what rounding of its own terms makes: those within f are not all
     * known.
     */
    private static final double NEAR = 100;
    private static final int MOST_DESCENTS = 200;
    private static final int MOST_HALVINGS = 40;

    private final ImplicitWork.Counter work;
    private double[] residual = {};
    private double[] correction = {};
    private double[] nextCorrection = {};
    private double[] trial = {};
    private double[] scale = {};                        // how large the unknowns were when the step began; the caller's
    private double[] first = {};                        // what corrections are judged by, besides the unknowns now
    private double[] floor = {};
    private double[] reached = {};
    private double size;                                // of the last correction, relative to the unknowns
    private double nextSize;
    private double damping;                             // the part of it that was taken
    private int iterations;
    private double left;                                // the last correction, relative to the unknowns one by one
    private boolean noCorrection;                       // whether the last failure was the linear solver's
    // whether only what is not rounding counts, each unknown by itself
    private boolean fine;

    Newton(ImplicitWork.Counter work) {
        this.work = work;
    }

    /**
     * Iterates from the guess in u.
     *
     * @param scale how large the unknowns were when the step began: what rounding and convergence are measured by, with
     *              u
     * @return whether it converged; u then holds the solution
     */
    boolean solve(NewtonProblem problem, double[] u, double[] scale) {
        fit(problem.size());
        this.scale = scale;
        System.arraycopy(scale, 0, first, 0, u.length);
        iterations = 0;
        size = Double.POSITIVE_INFINITY;
        fine = false;
        noCorrection = false;
        problem.evaluate(u, residual);
        if (Residuals.areZero(residual)) {
            return true;
        }
        if (!Residuals.areFinite(residual)) {
            return false;
        }
        return iterate(problem, u) && (left <= TOLERANCE || refine(problem, u));
    }

    /**
     * Iterates from u, whose residual is at hand; leaves how large the last correction was for each unknown by itself.
     */
    private boolean iterate(NewtonProblem problem, double[] u) {
        boolean haveCorrection = false;
        for (int most = iterations + MOST_ITERATIONS; iterations < most;) {
            iterations++;
            work.newtonIterations++;
            if (!haveCorrection && !linearise(problem, u)) {
                return false;
            }
            Outcome outcome = take(problem, u);
            if (outcome != Outcome.TAKEN) {
                return outcome == Outcome.SOLVED;
            }
            haveCorrection = damping == 1 && nextSize <= GOOD_CONTRACTION * size;
            // A linear solver that goes by all residuals together may leave small corrections out until large ones are
            // done.
            if (damping == 1 && (nextSize <= POLISHED || !fine && nextSize <= TOLERANCE && !haveCorrection)) {
                left = Residuals.areBelow(residual, floor, NEAR) ? 0 : NewtonUpdate.ownSize(nextCorrection, u, scale);
                for (int i = 0; i < u.length; i++) {
                    u[i] += nextCorrection[i];
                }
                return true;
            }
            if (haveCorrection) {
                double[] swap = correction;
                correction = nextCorrection;
                nextCorrection = swap;
                size = nextSize;
            }
        }
        return false;
    }

    /**
     * Goes on for small unknowns beside large ones, where rounding of the large ones hides them: residuals that are
     * rounding count as 0, and every correction beside how large the unknown is that it is for, however small. Where
     * that leaves one much smaller than it was, it is done once more; no more, since what should be 0 becomes ever
     * smaller.
     */
    private boolean refine(NewtonProblem problem, double[] u) {
        fine = true;
        for (int round = 0; round < 2 && left > TOLERANCE; round++) {
            for (int i = 0; i < u.length; i++) {
                first[i] = Math.max(Math.abs(scale[i]), Math.abs(u[i]));
            }
            problem.evaluate(u, residual);
            if (round == 0) {
                problem.refine(u);
            }
            dropRounding(problem, u);
            if (Residuals.areZero(residual)) {
                return true;
            }
            if (!Residuals.areFinite(residual) || !iterate(problem, u)) {
                evaluate(problem, u);                   // it may be that no correction improves what is good enough
                return Residuals.areZero(residual);
            }
        }
        return true;
    }

    private void evaluate(NewtonProblem problem, double[] at) {
        problem.evaluate(at, residual);
        dropRounding(problem, at);
    }

    private void dropRounding(NewtonProblem problem, double[] at) {
        problem.rounding(at, floor);
        if (fine) {
            Residuals.drop(residual, floor, NEAR);
        }
    }

    private double measure(double[] values, double[] at) {
        return fine ? NewtonUpdate.ownSize(values, at, first) : NewtonUpdate.size(values, at, first);
    }

    /** Sets the matrix up anew and computes the correction that it asks for; false if there is none. */
    private boolean linearise(NewtonProblem problem, double[] u) {
        problem.linearise(u);
        noCorrection = !NewtonUpdate.compute(problem, residual, correction);
        if (noCorrection) {
            return false;
        }
        size = measure(correction, u);
        return size != Double.POSITIVE_INFINITY;
    }

    private enum Outcome { TAKEN, SOLVED, NO_WAY }

    /**
     * Takes the correction, or so much of it that the next one is smaller. Leaves the next one and its size, and how
     * much was taken.
     */
    private Outcome take(NewtonProblem problem, double[] u) {
        for (damping = 1; damping >= SMALLEST_DAMPING; damping /= 2) {
            for (int i = 0; i < u.length; i++) {
                trial[i] = u[i] + damping * correction[i];
            }
            evaluate(problem, trial);
            if (damping == 1 && Residuals.areBelow(residual, floor, 1)) {
                System.arraycopy(trial, 0, u, 0, u.length);
                left = 0;
                return Outcome.SOLVED;
            }
            nextSize = Residuals.areFinite(residual) && NewtonUpdate.compute(problem, residual, nextCorrection)
                    ? measure(nextCorrection, trial) : Double.POSITIVE_INFINITY;
            if (nextSize <= (1 - damping / 4) * size) {
                System.arraycopy(trial, 0, u, 0, u.length);
                return Outcome.TAKEN;
            }
            if (size <= TOLERANCE) {
                boolean trusted = fine || Residuals.areBelow(residual, floor, NEAR);
                left = trusted ? NewtonUpdate.ownSize(correction, u, scale) : Double.MAX_VALUE;
                return Outcome.SOLVED;                  // no correction improves it any more: rounding
            }
        }
        return Outcome.NO_WAY;
    }

    /**
     * Looks for the solution where Newton's method found no way: a mechanical system's equation says that an energy is
     * least there. Corrections by a definite matrix go down in that energy, whose slope along them is the residual's
     * product with the correction; they are taken as far as the slope does not turn up again by much. Newton's method
     * itself takes over as soon as it converges, so that the solution is the exact one.
     *
     * @return whether it converged; false also where the problem has no definite matrix
     */
    boolean descend(NewtonProblem problem, double[] u, double[] scale) {
        double goal = 1e-1;
        problem.evaluate(u, residual);
        for (int i = 0; i < MOST_DESCENTS; i++) {
            work.newtonIterations++;
            if (!problem.lineariseDefinite(u) || !NewtonUpdate.compute(problem, residual, correction)) {
                return false;
            }
            double length = NewtonUpdate.size(correction, u, first);
            if (length < goal) {
                System.arraycopy(u, 0, reached, 0, u.length);
                if (solve(problem, u, scale)) {
                    return true;
                }
                System.arraycopy(reached, 0, u, 0, u.length);
                problem.evaluate(u, residual);
                problem.lineariseDefinite(u);
                if (!NewtonUpdate.compute(problem, residual, correction)) {
                    return false;
                }
                goal = length / 10;
            }
            if (!goDown(problem, u)) {
                iterations = i + 1;
                return false;
            }
        }
        iterations = MOST_DESCENTS;
        return false;
    }

    /**
     * Takes the correction, or the part of it up to where the slope is about flat. Leaves the residual of the new u.
     */
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
            part *= Math.max(0.1, Math.min(0.5, there < 0 ? slope / (slope - there) : 0));    // the secant's zero
        }
        return false;
    }

    /** One correction, whatever it leaves: the linearised equation. */
    boolean solveLinearised(NewtonProblem problem, double[] u) {
        fit(problem.size());
        iterations = 1;
        work.newtonIterations++;
        size = Double.POSITIVE_INFINITY;
        noCorrection = false;
        problem.evaluate(u, residual);
        if (Residuals.areZero(residual)) {
            return true;
        }
        if (!Residuals.areFinite(residual)) {
            return false;
        }
        problem.linearise(u);
        noCorrection = !NewtonUpdate.compute(problem, residual, correction);
        if (noCorrection) {
            return false;
        }
        for (int i = 0; i < u.length; i++) {
            u[i] += correction[i];
        }
        return true;
    }

    /** What the last failure looked like, for a message. */
    String describeFailure() {
        return noCorrection
                ? String.format(Locale.ROOT, "the linear solver failed at Newton's iteration %d, with a largest"
                        + " residual of %.2g: the matrix is singular or not finite, or GMRES did not converge",
                        iterations, NewtonUpdate.largest(residual))
                : String.format(Locale.ROOT, "Newton's iteration did not converge: after %d iterations the"
                        + " correction is %.2g of the unknowns (limit %.0e) and the largest residual %.2g",
                        iterations, size, TOLERANCE, NewtonUpdate.largest(residual));
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
