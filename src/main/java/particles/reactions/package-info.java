/**
 * Forces that depend on the sum of all others: contact forces and friction, and the constraint forces of rods and
 * wires. They are added after all effects.
 *
 * <p>One particle on surfaces has a closed form ({@link particles.reactions.RestingContacts}); rods and wires are a
 * banded symmetric system ({@link particles.reactions.RigidConstraints}). Where a particle has both, they form one
 * small complementarity problem. In statically indeterminate cases - a square with both diagonals, a prop between rough
 * walls - rigid bodies do not determine the loads, and no motion depends on them: rods then share the load by least
 * squares, and static friction holds if any load allows it.
 */
package particles.reactions;
