/**
 * How fast a system's small motions about its present state are: the eigenvalues of its linearised equations, which
 * decide how long an explicit step may be. Undamped systems by Lanczos' iteration on the symmetric da/dx, all others by
 * Arnoldi's on the whole Jacobian; neither ever writes the matrix down.
 */
package particles.experiments.spectrum;
