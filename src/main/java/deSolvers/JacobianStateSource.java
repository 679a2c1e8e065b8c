package deSolvers;

/**
 * A source that knows the Jacobian J = df/ds of its equation ds/dt = f(s, t). Implicit solvers use it; for other
 * sources they take finite differences of f. If a step's equation has one solution, both lead to it: the Jacobian only
 * decides how fast Newton's method converges. If there are several, they may lead to different ones.
 *
 * <p>A source that is also a {@link SecondOrderStateSource} of dimension 3 may give the 3 x 3 blocks of its forces'
 * derivatives as well, so that a solver can work on the 3n equations for the velocities instead of the 6n of the state.
 */
public interface JacobianStateSource extends DEStateSource {

    /** The share of the Jacobian that {@link #addJacobianBlocks} adds. */
    enum Blocks {
        /** Nothing: the source has no blocks. */
        NONE,
        /**
         * An approximation; the product {@link #getJacobianProduct} is exact, and the blocks serve to precondition it.
         */
        APPROXIMATE,
        /** Everything. */
        EXACT,
    }

    /**
     * Multiplies the Jacobian at the current state and time with a direction; changes neither.
     *
     * @param direction a direction w in the state space; n long
     * @param product   receives J w, per unit of time; n long, another array than {@code direction}
     */
    void getJacobianProduct(double[] direction, double[] product);

    /** @return the share of the Jacobian that {@link #addJacobianBlocks} adds; the same throughout a step */
    default Blocks getJacobianBlocks() {
        return Blocks.NONE;
    }

    /**
     * Adds the blocks of the force derivatives at the current state and time, where the force on particle i is its
     * acceleration times its mass. Particles with inverse mass 0 may be given or left out; they count as held.
     *
     * @param blocks receives them
     */
    default void addJacobianBlocks(ForceDerivatives blocks) {
    }

    /**
     * Returns the masses that make the blocks of {@link #addJacobianBlocks} symmetric where the forces have a
     * potential.
     *
     * @param i number of a particle's block in the state
     * @return 1/m (1/kg), 0 for a particle that no force moves
     */
    default double getInverseMass(int i) {
        return 1;
    }
}
