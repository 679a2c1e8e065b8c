package deSolvers;

/**
 * A source whose equation is of second order, x'' = a(x, x', t), reduced to first order as on the slide "An Aside:
 * Order of an ODE": the state is made of blocks (x<sub>1</sub>, v<sub>1</sub>, x<sub>2</sub>, v<sub>2</sub>, ...), each
 * of {@link #getDimension() d} positions followed by the d velocities that are their derivatives.
 *
 * <p>The symplectic solvers need to know which entries are positions and which are velocities; all others treat such a
 * source like any other.
 */
public interface SecondOrderStateSource extends DEStateSource {

    /**
     * The number of positions, and of velocities, in one block.
     *
     * @return d, 1 or more: 3 for particles in space, 1 for the slides' example oscillator; 2d divides the state size
     */
    int getDimension();

    /**
     * Whether a(x, v, t) depends on v, as it does with drag or damped springs. Where it does, the symplectic solvers
     * solve for the velocity at the end of a step, which costs them evaluations and keeps their order.
     *
     * @return true unless the source knows that its acceleration is a function of position and time only
     */
    default boolean accelerationDependsOnVelocity() {
        return true;
    }

    /**
     * Returns the largest term that a(x, v, t) was summed from in the last evaluation, if it may be far larger than the
     * sum: constraint forces that cancel on a light particle between heavy ones. Its round-off is left in a, so an
     * iteration that does not shrink below it has converged.
     *
     * @return the term's size (in the unit of a); 0 if a is about as large as its terms
     */
    default double getLargestTerm() {
        return 0;
    }
}
