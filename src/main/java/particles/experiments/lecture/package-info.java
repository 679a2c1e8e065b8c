/**
 * The slides' own figures.
 */
package particles.experiments.lecture;
