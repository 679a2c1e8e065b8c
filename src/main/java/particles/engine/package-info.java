/**
 * How forces are summed: one pass over the effects and reactions, on one thread or several with the same bits, and the
 * Jacobian of the sum. Nobody has to read this room to write a law.
 */
package particles.engine;
