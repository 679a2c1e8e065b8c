/**
 * What accuracy, stiffness and effects cost: work-precision diagrams, the stiff gallery, and the time of each effect.
 */
package particles.experiments.work;
