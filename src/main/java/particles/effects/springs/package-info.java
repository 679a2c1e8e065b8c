/**
 * The damped spring: the law itself in {@link particles.effects.springs.SpringForce}, its table of springs, the loop
 * that runs, and its derivative.
 */
package particles.effects.springs;
