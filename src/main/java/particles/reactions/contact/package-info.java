/**
 * Contact of one particle with surfaces: contact modes, normal forces, friction, and their derivatives for implicit
 * solvers.
 */
package particles.reactions.contact;
