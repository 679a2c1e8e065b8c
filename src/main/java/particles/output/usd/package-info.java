/**
 * The motion of a run as files for other programs: a USD stage, and Wavefront OBJ files. Both are written while the run
 * goes on, so that their memory does not grow with its length.
 */
package particles.output.usd;
