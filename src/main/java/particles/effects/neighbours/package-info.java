/** Search for neighbours: {@link particles.effects.neighbours.NeighbourGrid}, and Verlet's lists made from it. */
package particles.effects.neighbours;
