/**
 * Paths in state space, position against velocity, over a reference and the vector field.
 */
package particles.experiments.phase;
