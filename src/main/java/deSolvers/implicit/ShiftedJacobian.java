package deSolvers.implicit;

import deSolvers.DEStateSource;
import deSolvers.StepTransaction;

/**
 * The matrix I - g J of all implicit methods, with J = df/ds at some state: solves (I - g J) x = b for real and complex
 * g. How it does so depends on the source; {@link JacobianChoice} chooses.
 */
interface ShiftedJacobian {

    /**
     * Sets up J at a state and the source's present time.
     *
     * @param source the step's source; left anywhere
     * @param state  the state; not kept
     * @param slope  f at that state; not kept
     * @param h      a step (s), for how far the state may be expected to move
     * @param kind   the variant of J
     */
    void setJacobian(StepTransaction source, double[] state, double[] slope, double h, Kind kind);

    /** The variant of J; an implementation without variants always sets up J itself. */
    enum Kind {
        /** J. */
        EXACT,
        /**
         * J with the negative semidefinite part of each spring's stiffness, so that the matrix is positive definite.
         */
        PROJECTED,
        /**
         * PROJECTED; where J comes from differences, entries far smaller than others are varied by a part of
         * themselves.
         */
        CAREFUL
    }

    /**
     * Whether J is right for entries of m that are far smaller than others, so that a small correction to them means
     * something.
     */
    default boolean seesSmallEntries(double[] m) {
        return true;
    }

    /** Whether J, once set up, may serve later sub-steps. */
    default boolean keepsJacobian() {
        return true;
    }

    /** Discards all memory of earlier steps. */
    default void forget() {
    }

    /** The number of iterations after which Newton's method gives up. */
    default int mostIterations() {
        return 60;
    }

    /** Prepares for a real g; false if the matrix is found to be singular. */
    boolean prepare(double g);

    /** Prepares for a complex g besides; false if the matrix is found to be singular. */
    boolean prepareComplex(double gRe, double gIm);

    /**
     * Solves with the real g. The source's clock has to be where it was at {@link #setJacobian}.
     *
     * @return false if the matrix is singular or the iterations did not converge
     */
    boolean solve(double[] b, double[] x, double tolerance);

    /** Solves with the complex g; a vector has an array of real parts and one of imaginary parts. */
    boolean solveComplex(double[][] b, double[][] x, double tolerance);

    /** Makes the start of a step the guess with which Newton's method begins. */
    default void guess(DEStateSource client, double[] m) {
    }

    /** Computes entries of m = s + g f(m) that follow from others, so that they are exact. */
    default void complete(double[] start, double g, double[] m) {
    }

    /**
     * The slope along a direction, for the line search: positive before the solution, negative beyond it.
     *
     * @param residual  the residual at some point along the direction
     * @param solution  the solution of (I - g J) x = residual
     * @param direction the direction
     */
    double slope(double[] residual, double[] solution, double[] direction);

    /**
     * Estimates the round-off of f in each entry of g f, from the last J.
     *
     * @param state the state
     * @param slope f at that state
     * @param g     a step (s)
     * @param size  receives for each entry the size of the terms whose sum is rounded
     */
    void terms(double[] state, double[] slope, double g, double[] size);
}
