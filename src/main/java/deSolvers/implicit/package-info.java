/**
 * Implicit methods: the new state is on both sides of their equations and has to be solved for. In return stiff springs
 * and strong damping do not limit the step.
 *
 * <h2>The equation</h2>
 * Backward Euler and the implicit midpoint rule both solve m = s + g f(m, t<sub>m</sub>): backward Euler with g = h at
 * the end of the step, the midpoint rule with g = h/2 at its middle. {@code Newton} solves it; each iteration needs a
 * linear system with the matrix I - g J, where J = df/ds. {@link deSolvers.implicit.LinearisedEulerSolver} takes one
 * such iteration and stops. {@link deSolvers.implicit.RadauIIASolver} has three stages; a change of variables splits
 * their system into one with I - g J for a real g and one for a complex g.
 *
 * <h2>The matrix</h2>
 * {@code ShiftedJacobian} solves linear systems with I - g J, whatever the form of the matrix. {@code JacobianChoice}
 * chooses by the kind and size of the source:
 * <ul>
 * <li>{@code DenseSystem}, for small sources: a full matrix, with J from the source or by differences;</li>
 * <li>{@code ProductSystem}, for large ones: no matrix, only products J w, from the source or by one difference
 *     each;</li>
 * <li>{@code ReducedVelocitySystem}, for particles that offer the 3 x 3 blocks of their force derivatives: the
 *     positions are eliminated, which leaves the sparse matrix M - g dF/dv - g<sup>2</sup> dF/dx for the
 *     velocities.</li>
 * </ul>
 * The linear systems themselves are solved in {@link deSolvers.linear}.
 *
 * <h2>Compressed springs</h2>
 * A compressed spring pushes its ends outwards sideways, which can make the matrix indefinite. The linearised step
 * leaves that part out. Newton's method begins with the exact matrix, with which it converges fastest, and leaves the
 * part out where the exact correction does not lead down in energy.
 *
 * <h2>When Newton's method stops</h2>
 * It stops when the correction of every entry is at most 1e-10 of that entry, or when all residuals are round-off. So
 * an entry of 1e-3 beside one of 1e12 is right to ten digits too. Limits: round-off that the derivative of f does not
 * show, as in (x + 1e8) - 1e8, counts as an error, and such a step ends in an exception; and GMRES, which sees all
 * residuals together, may leave out a correction to an entry more than twelve powers of ten below others.
 *
 * <p>Reference: E. Hairer, G. Wanner, <i>Solving Ordinary Differential Equations II</i>, 2nd ed., Springer 1996;
 * P. Deuflhard, <i>Newton Methods for Nonlinear Problems</i>, Springer 2004; D. Baraff, A. Witkin, <i>Large Steps in
 * Cloth Simulation</i>, SIGGRAPH 1998.
 */
package deSolvers.implicit;
