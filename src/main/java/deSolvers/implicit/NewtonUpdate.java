package deSolvers.implicit;

import deSolvers.DEStateSource;
import deSolvers.JacobianStateSource;
import deSolvers.SecondOrderStateSource;

/**
 * The update of Newton's method: the solution of the linearised equation, and its size relative to
 * the unknowns.
 */
final class NewtonUpdate {
    /** Round-off of a sum, relative to its terms. */
    private static final double ROUND_OFF = 2 * Math.ulp(1.0);
    /** The round-off within f, beside that of the terms of its sums. */
    private static final double WITHIN = 100;
    /**
     * Below this all is round-off, in any unit: a motion that a solver damps to nothing ends there, where a force may
     * be 0 because it cannot be computed, though its derivative is not.
     */
    private static final double NOTHING = 1e-270;

    private NewtonUpdate() {
    }

    /**
     * Solves the linearised equation. For the linear solver, the residual is scaled by a power of two, which changes no
     * digit, so that its square neither under- nor overflows.
     *
     * @param residual r(m); the same afterwards
     * @param result   receives the update
     * @return false if there is none
     */
    static boolean solve(ShiftedJacobian jacobian, double[] residual, double[] result, double tolerance) {
        double scale = Math.max(Double.MIN_NORMAL, Math.ulp(largest(residual)));
        for (int i = 0; i < residual.length; i++) {
            residual[i] /= scale;
        }
        boolean solved = jacobian.solve(residual, result, tolerance);
        for (int i = 0; i < residual.length; i++) {
            residual[i] *= scale;
            result[i] *= scale;
        }
        return solved;
    }

    /**
     * Measures an update.
     *
     * @param m        the unknowns that it is for
     * @param start    the unknowns at the beginning of the step
     * @param roundOff the round-off of each unknown
     * @return its largest entry relative to the unknown, which counts as no smaller than its round-off over Newton's
     *         tolerance; infinite where that leaves the numbers
     */
    static double size(double[] update, double[] m, double[] start, double[] roundOff) {
        double size = 0;
        for (int i = 0; i < m.length; i++) {
            double unknown = Math.max(Math.max(Math.abs(m[i]), Math.abs(m[i] + update[i])), Math.abs(start[i]));
            double counted = Math.max(unknown, WITHIN * roundOff[i] / Newton.TOLERANCE);
            size = Math.max(size, update[i] == 0 ? 0 : Math.abs(update[i]) / counted);
        }
        return size <= Double.MAX_VALUE ? size : Double.POSITIVE_INFINITY;
    }

    /**
     * The round-off of each equation's sum. Constraint forces are not in the blocks and may be far larger than their
     * sum; the round-off of each velocity is therefore that of the largest term of any.
     *
     * @param roundOff the terms of g f; receives the round-off
     */
    static void roundOff(DEStateSource source, double[] start, double[] m, double[] roundOff) {
        boolean constrained = source instanceof JacobianStateSource particles && !particles.hasExactJacobian();
        int d = constrained ? 3 : 1;
        double position = 0;
        double velocity = 0;
        for (int i = 0; i < m.length; i++) {
            roundOff[i] += Math.abs(start[i]) + Math.abs(m[i]);
            position = i / d % 2 == 0 ? Math.max(position, roundOff[i]) : position;
            velocity = i / d % 2 == 1 ? Math.max(velocity, roundOff[i]) : velocity;
        }
        for (int i = 0; i < m.length; i++) {
            roundOff[i] = NOTHING + ROUND_OFF
                    * (!constrained ? roundOff[i] : i / d % 2 == 0 ? position : velocity);
        }
    }

    /**
     * Whether an update of positions and velocities is no larger than the largest round-off of any position, or of any
     * velocity: an unknown driven by the round-off of a stiff neighbour gets no smaller.
     *
     * @param g the step of g f (s)
     */
    static boolean isRoundOffOfTheLargest(DEStateSource source, double[] update, double g, double[] roundOff) {
        if (!(source instanceof SecondOrderStateSource particles)) {
            return false;
        }
        int d = particles.getDimension();
        double kick = ROUND_OFF * Math.abs(g) * particles.getLargestTerm();
        double[] largest = {Math.abs(g) * kick, kick};  // of positions, of velocities
        for (int i = 0; i < update.length; i++) {
            largest[i / d % 2] = Math.max(largest[i / d % 2], roundOff[i]);
        }
        for (int i = 0; i < update.length; i++) {
            if (!(Math.abs(update[i]) <= largest[i / d % 2])) {
                return false;
            }
        }
        return true;
    }

    /** The largest entry by its size; NaN if one is. */
    static double largest(double[] values) {
        double largest = 0;
        for (double value : values) {
            largest = Math.max(largest, Math.abs(value));
        }
        return largest;
    }
}
