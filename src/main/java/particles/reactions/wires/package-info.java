/**
 * The curves along which beads slide: straight, circular, and the graph of a function.
 */
package particles.reactions.wires;
