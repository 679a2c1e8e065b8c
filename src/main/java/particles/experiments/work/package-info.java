/**
 * The cost of accuracy, stiffness and effects: work-precision diagrams, the stiff gallery, and the time of each effect.
 */
package particles.experiments.work;
