/**
 * Forces that answer the total of all others: what keeps a resting particle out of a plane, and the friction that comes
 * with it. They act after all effects and only where something is held.
 */
package particles.reactions;
