/**
 * Forces that follow from state and time: one law, one file. Each says what energy it stores, dissipates or brings in, so
 * that a system's energy is a sum without special cases, and what it claims of itself
 * ({@link particles.Effect.Trait}), which a test holds it to.
 */
package particles.effects;
