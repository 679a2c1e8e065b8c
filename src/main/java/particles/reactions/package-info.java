/**
 * Forces that answer the total of all others: what keeps a resting particle out of a plane, and the friction that comes
 * with it; what keeps rods as long as they are and beads on their wires. They act after all effects and only where
 * something is held.
 *
 * <p>One particle on planes is answered in closed form ({@link particles.reactions.RestingContacts}), rods and wires by
 * a narrow symmetric system ({@link particles.reactions.RigidConstraints}). Where a particle has both, they are one
 * small complementarity problem: rods, wires, pushes and sliding friction at once. Where more is held than needed - a
 * square with both diagonals in its plane, a prop between rough walls - rigid bodies do not say who carries what; no
 * motion depends on it. Then rods share alike, and static friction holds if there is any share with which it can.
 */
package particles.reactions;
