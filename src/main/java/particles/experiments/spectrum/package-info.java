/**
 * The spectrum of a system: the eigenvalues of its linearised equations about its present state, which limit the step
 * of explicit solvers. Undamped systems use Lanczos' iteration on the symmetric da/dx, all others Arnoldi's on the
 * whole Jacobian. Both only multiply by the matrix and never store it.
 */
package particles.experiments.spectrum;
