/**
 * Checks of the rules that hold for every solver, whatever its method: the clock, what it may remember of earlier
 * steps, sources of any size, steps of any sign, and sources that fail.
 */
package particles.teaching.contract;
