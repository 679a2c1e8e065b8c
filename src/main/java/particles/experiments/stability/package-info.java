/**
 * Stability experiments: stability regions measured on the solvers' own code, and the largest safe deltaT of a scene.
 * That is predicted from the eigenvalues of the scene's linearised equations, which Arnoldi's iteration finds without
 * storing the Jacobian.
 */
package particles.experiments.stability;
