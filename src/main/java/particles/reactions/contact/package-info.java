/**
 * What a surface does to one particle that touches it: which surfaces it touches, how hard they push, how friction
 * answers, and the derivative of all that for implicit solvers.
 */
package particles.reactions.contact;
