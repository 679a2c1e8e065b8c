/**
 * The slides' own figures, and the lecture's exercise on the cost of RK4 against midpoint.
 */
package particles.experiments.lecture;
