/**
 * Small dense linear algebra for constraint forces: Cholesky factors of an envelope matrix, solutions of least norm,
 * and linear complementarity by an active-set method.
 */
package particles.reactions.algebra;
