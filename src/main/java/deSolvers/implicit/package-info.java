/**
 * Implicit methods: the new state is on both sides of their equations and has to be solved for. In return stiff springs
 * and strong damping do not limit the step.
 *
 * <h2>The equation</h2>
 * Backward Euler and the implicit midpoint rule both solve m = s + g f(m, t<sub>m</sub>) for a state m. Backward Euler:
 * g = h, t<sub>m</sub> is the end of the step, m the new state. Implicit midpoint: g = h/2, t<sub>m</sub> the middle,
 * and the new state is 2 m - s. {@code Newton} solves the equation; each iteration solves a linear system with the
 * matrix I - g J, where J = df/ds. {@link deSolvers.implicit.LinearisedEulerSolver} takes one such iteration and stops.
 * {@link deSolvers.implicit.RadauIIASolver} has three stages. A change of variables splits their system into two
 * smaller ones, with a real g and a complex g; solving these costs less.
 *
 * <h2>The matrix</h2>
 * {@code ShiftedJacobian} solves linear systems with I - g J, whatever the form of the matrix. {@code JacobianChoice}
 * chooses by the kind and size of the source:
 * <ul>
 * <li>{@code DenseSystem}, for sources of up to 5000 entries: a full matrix, with J by differences; a larger
 *     source is refused with an {@code IllegalArgumentException};</li>
 * <li>{@code ReducedVelocitySystem}, for particles that offer the 3 x 3 blocks of their force derivatives: the
 *     positions are eliminated, which leaves the sparse matrix M - g dF/dv - g<sup>2</sup> dF/dx for the
 *     velocities. Rods, wires and contacts that join particles have no blocks: then GMRES multiplies with J by one
 *     difference of f at a time, and the blocks of the others are its preconditioner.</li>
 * </ul>
 * The linear systems themselves are solved in {@link deSolvers.linear}.
 *
 * <h2>Compressed springs</h2>
 * If an end of a compressed spring moves sideways, the spring pushes it further that way. This negative stiffness can
 * make the matrix indefinite; a correction may then lead up in energy instead of down. The linearised step leaves the
 * negative stiffness out. Newton's method begins with the full matrix, with which it converges fastest, and leaves it
 * out where a correction does not lead down or has to be shortened.
 *
 * <h2>When Newton's method stops</h2>
 * It stops when the correction of every entry is at most 1e-10 of that entry, or when all residuals are round-off. So
 * an entry of 1e-3 beside one of 1e6 is right to ten digits too. If f itself loses digits, as (x + 1e8) - 1e8 does,
 * Newton's method takes the round-off for an error, and the step ends in an exception.
 *
 * <p>Reference: E. Hairer, G. Wanner, <i>Solving Ordinary Differential Equations II</i>, 2nd ed., Springer 1996;
 * P. Deuflhard, <i>Newton Methods for Nonlinear Problems</i>, Springer 2004; D. Baraff, A. Witkin, <i>Large Steps in
 * Cloth Simulation</i>, SIGGRAPH 1998.
 */
package deSolvers.implicit;
