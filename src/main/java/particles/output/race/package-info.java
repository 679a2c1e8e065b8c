/**
 * Several runs of a scene side by side, as a film and as a sheet for print.
 */
package particles.output.race;
