/**
 * The commands that run an experiment and write a page of results.
 */
package particles.app.experiments;
