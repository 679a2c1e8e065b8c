package deSolvers.implicit;

/**
 * The equation r(u) = 0 as Newton's method sees it: residuals, linearisations and their solutions. The unknown u is the
 * stage itself, or only its velocities.
 */
interface NewtonProblem {

    /** The number of unknowns. */
    int size();

    /** Moves the source to u and computes the residual there: one evaluation of the derivative. */
    void evaluate(double[] u, double[] residual);

    /** Sets up the matrix -dr/du at u. */
    void linearise(double[] u);

    /**
     * Sets up, in place of -dr/du, a positive definite matrix near it.
     *
     * @return false if the problem has none
     */
    default boolean lineariseDefinite(double[] u) {
        return false;
    }

    /**
     * Solves (-dr/du) correction = residual with the matrix of the last {@link #linearise}.
     *
     * @return false if the matrix is singular or the linear solver did not converge
     */
    boolean correct(double[] residual, double[] correction);

    /** How large rounding errors make a residual at u, entry by entry, by the last linearisation. */
    void rounding(double[] u, double[] floor);

    /**
     * Prepares for what is left of small unknowns at u, the place of the last {@link #evaluate}, when the large ones
     * are solved. It may move the source.
     */
    default void refine(double[] u) {
    }
}
