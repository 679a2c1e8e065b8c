/**
 * Force laws: one law, one file. Each says what energy it stores, dissipates or brings in and what it claims of itself
 * ({@link particles.law.Effect.Trait}); tests hold it to that. Its nested class {@code Keys} says what scenes can say
 * of it, and {@link particles.effects.EffectCatalog} is the list of all.
 */
package particles.effects;
