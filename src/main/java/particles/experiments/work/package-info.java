/**
 * The cost of accuracy, stiffness and effects: work-precision diagrams, the lecture's exercise on RK4 against midpoint,
 * the stiff gallery, and the time of each effect.
 */
package particles.experiments.work;
