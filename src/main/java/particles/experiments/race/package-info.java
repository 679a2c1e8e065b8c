/**
 * Races: several solvers do the same work on one scene, and the most accurate one wins.
 */
package particles.experiments.race;
