/**
 * A grid of runs: a scene with a few keys varied over lists of values, and measures of each run. It is the experiment
 * behind {@code gradle sweep}.
 */
package particles.experiments.grid;
