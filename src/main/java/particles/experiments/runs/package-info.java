/**
 * The base of all experiments: runs of a scene with a choice of solvers, settings that cost equal work,
 * CPU time, and fitted lines.
 */
package particles.experiments.runs;
