/**
 * Forces that depend on the sum of all others: contact forces and friction, and the constraint forces of rods and
 * wires. They are added after all effects.
 *
 * <p>{@link particles.reactions.RestingContacts} computes the contact forces on a single particle directly, by a
 * formula. {@link particles.reactions.RigidConstraints} solves a system of linear equations for the forces in rods and
 * wires. A particle on a surface and on a rod needs both at once: contacts can only push, so the equations come with
 * conditions of sign (a linear complementarity problem).
 *
 * <p>The forces are not always unique: a square of rods with both diagonals, or a prop between rough walls, is
 * statically indeterminate. As long as the same particles stick, the accelerations are the same for each solution. Rods
 * take the solution with the least sum of squares. Static friction holds if at least one solution stays within its
 * limits.
 */
package particles.reactions;
