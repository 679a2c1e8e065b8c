/**
 * Hard cases for particle systems and their solvers together: each class says why its case is hard and what every
 * solver has to do with it - follow it, stay bounded, grow as documented, or fail loudly. Run by
 * {@code gradle hardTests}.
 */
package particles.hard;
