/**
 * The spectrum of a system: the eigenvalues of its linearised equations about its present state, which limit the step
 * of explicit solvers. Arnoldi's iteration only multiplies by the Jacobian and never stores it.
 */
package particles.experiments.spectrum;
