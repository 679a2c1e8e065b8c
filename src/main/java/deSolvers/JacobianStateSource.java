package deSolvers;

/**
 * A source of particles in space ({@link #getDimension} is 3) that knows how its forces change with positions and
 * velocities: the 3 x 3 blocks of the forces' derivatives. With them an implicit solver works on the 3n equations for
 * the velocities instead of the 6n of the state. For other sources implicit solvers take finite differences of f. If a
 * step's equation has one solution, both lead to it: the derivatives only decide how fast Newton's method converges. If
 * there are several, they may lead to different ones.
 */
public interface JacobianStateSource extends SecondOrderStateSource {

    /**
     * @return whether the blocks are the whole derivative; otherwise they only serve as a preconditioner, and solvers
     *         multiply with the Jacobian by differences of f. The same throughout a step
     */
    boolean hasExactJacobian();

    /**
     * Adds the blocks of the force derivatives at the current state and time, where the force on particle i is its
     * acceleration times its mass. Particles with inverse mass 0 may be given or left out; they count as held.
     *
     * @param blocks receives them
     */
    void addJacobianBlocks(ForceDerivatives blocks);

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
