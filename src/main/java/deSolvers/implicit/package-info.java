/**
 * Implicit methods: the new state stands on both sides of their equations and has to be solved for. In return stiff
 * springs and strong damping do not limit the step.
 *
 * <p>Both one-stage methods come down to one equation, m = s + g f(m, t<sub>m</sub>), with g = h at the end of the step
 * for backward Euler and g = h/2 in its middle for the implicit midpoint rule. {@link deSolvers.implicit.ImplicitStage}
 * solves it by Newton's method, and the size and kind of the source decide what the linear systems are:
 * <ul>
 * <li>small sources of any kind: the dense matrix I - g J, factorised (EJML); J from the source or by differences;</li>
 * <li>large ones: products J w only, from the source or by one difference each, and GMRES; where that fails, the full
 * matrix
 *     after all, up to 2000 rows;</li>
 * <li>particles in space that offer the 3 x 3 blocks of their force derivatives: the velocities are the only unknowns,
 *     their matrix M - g dF/dv - g<sup>2</sup> dF/dx is sparse, and symmetric where the forces have a potential. A
 *     sparse factorisation, front by front in an order found by nested dissection, is made where it takes less work
 *     than iterations; otherwise conjugate gradients solve it while it is positive definite, and GMRES where it is
 *     not.</li>
 * </ul>
 *
 * <p>The Radau method splits the system of its three stages into a real and a complex one of the same size as the
 * source ({@link deSolvers.implicit.RadauChoice} says how they are solved): full matrices for small sources, products
 * and GMRES for large ones, and for particles that offer their blocks the velocities alone, by GMRES with one sparse
 * real matrix as the preconditioner of both.
 *
 * <p>The derivative of a compressed spring's force is indefinite across the spring. It is used as it is, not clamped,
 * since with the exact matrix Newton's iteration converges fastest; where it loses definiteness, the method changes
 * from conjugate gradients to GMRES. Where Newton's iteration, damped by Deuflhard's monotonicity test, finds no way, a
 * matrix without the outward pushing parts leads down in energy until it does; and where even that fails, the solution
 * is followed from g = 0 to its full value. All three end with the exact matrix, at a solution of the nonlinear
 * equation.
 *
 * <p>Convergence is judged for each unknown by its own size, where what is left of its equation is more than 100 times
 * the rounding of the equation's own terms: an entry of 1e-3 beside one of 1e12 is right to 4e-14. Limits remain.
 * Conjugate gradients and GMRES reduce all residuals together and may leave small corrections out: by GMRES, entries 12
 * powers of ten below others were right to 1e-12, but of some 14 powers below one was accepted that was 6e-5 off. An
 * entry that should be 0 is followed down twice by ten digits and then left. And rounding inside f that its derivative
 * does not show, as of (x + 1e8) - 1e8, counts as an error where it is more than 1e-10 of a small entry: such a step
 * ends in an exception.
 *
 * <p>Reference: E. Hairer, G. Wanner, <i>Solving Ordinary Differential Equations II</i>, 2nd ed., Springer 1996;
 * P. Deuflhard, <i>Newton Methods for Nonlinear Problems</i>, Springer 2004; D. Baraff, A. Witkin, <i>Large Steps in
 * Cloth Simulation</i>, SIGGRAPH 1998.
 */
package deSolvers.implicit;
