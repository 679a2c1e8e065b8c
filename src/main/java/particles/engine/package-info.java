/**
 * Sums the forces of effects and reactions, on one thread or several with the same bits, and computes the Jacobian. To
 * write a law you need not read this package.
 */
package particles.engine;
