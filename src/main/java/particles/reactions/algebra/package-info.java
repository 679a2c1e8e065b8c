/**
 * Small dense linear algebra for constraint forces: factors of a matrix in an envelope, solutions of least norm,
 * and linear complementarity by an active-set method.
 */
package particles.reactions.algebra;
