/**
 * What a student's solver does, in numbers and charts: order, energy, work, stability function and stability region.
 */
package particles.teaching.figures;
