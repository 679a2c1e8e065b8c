/**
 * What a scene is composed of: particles, springs, shapes (ropes, cloths, blocks), rods, wires and rules, each with
 * its scene keys and what it builds.
 */
package particles.scene.parts;
