/**
 * Stability experiments: stability regions measured on the solvers' own code, and the largest safe deltaT of a scene.
 */
package particles.experiments.stability;
