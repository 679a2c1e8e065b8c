/**
 * The parts of a scene: particles, springs, shapes (ropes, cloths, blocks), rods, wires and rules, each with its scene
 * keys and the code that builds it.
 */
package particles.scene.parts;
