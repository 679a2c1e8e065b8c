/**
 * One painter for each kind of thing in a frame: particles, springs, surfaces, wires, trails, glow, shadows.
 */
package particles.output.painters;
