/**
 * A race: several solvers do the same work on one scene.
 */
package particles.experiments.race;
