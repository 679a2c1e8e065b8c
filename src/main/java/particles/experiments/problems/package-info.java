/** Motions with known solutions, which experiments measure solvers on. */
package particles.experiments.problems;
