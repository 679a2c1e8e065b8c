/**
 * Measurements of a student's solver, in numbers and charts: order, energy, work, stability function and stability
 * region.
 */
package particles.teaching.figures;
