/**
 * Implicit methods: the new state stands on both sides of their equations and has to be solved for. In return stiff
 * springs and strong damping do not limit the step.
 *
 * <p>Both one-stage methods come down to one equation, m = s + g f(m, t<sub>m</sub>), with g = h at the end of the step for
 * backward Euler and g = h/2 in its middle for the implicit midpoint rule. {@link deSolvers.implicit.ImplicitStage} solves
 * it by Newton's method, and the size and kind of the source decide what the linear systems are:
 * <ul>
 * <li>small sources of any kind: the dense matrix I - g J, factorised (EJML); J from the source or by differences;</li>
 * <li>large ones: products J w only, from the source or by one difference each, and GMRES;</li>
 * <li>particles in space that offer the 3 x 3 blocks of their force derivatives: the velocities are the only unknowns,
 *     their matrix M - g dF/dv - g<sup>2</sup> dF/dx is sparse, and symmetric where the forces have a potential. Conjugate
 *     gradients solve it while it is positive definite and not too ill-conditioned; otherwise GMRES, or a sparse
 *     factorisation, front by front in an order found by nested dissection.</li>
 * </ul>
 *
 * <p>The Radau method splits the system of its three stages into a real and a complex one of the same size as the source
 * ({@link deSolvers.implicit.RadauChoice} says how they are solved): full matrices for small sources, products and GMRES for
 * large ones, and for particles that offer their blocks the velocities alone, by GMRES with one sparse real matrix as the
 * preconditioner of both.
 *
 * <p>The derivative of a compressed spring's force is indefinite across the spring. It is used as it is, not clamped, since
 * with the exact matrix Newton's iteration converges fastest; where it loses definiteness, the method changes from conjugate
 * gradients to GMRES. Where Newton's iteration, damped by Deuflhard's monotonicity test, finds no way, a matrix without
 * the outward pushing parts leads down in energy until it does; and where even that fails, the solution is followed from
 * g = 0 to its full value. All three end with the exact matrix, at a solution of the nonlinear equation.
 *
 * <p>Reference: E. Hairer, G. Wanner, <i>Solving Ordinary Differential Equations II</i>, 2nd ed., Springer 1996;
 * P. Deuflhard, <i>Newton Methods for Nonlinear Problems</i>, Springer 2004; D. Baraff, A. Witkin, <i>Large Steps in Cloth
 * Simulation</i>, SIGGRAPH 1998.
 */
package deSolvers.implicit;
