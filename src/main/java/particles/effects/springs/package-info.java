/**
 * Damped springs: the law in {@link particles.effects.springs.SpringForce}, the table of springs, the fast loops, and
 * the derivative.
 */
package particles.effects.springs;
