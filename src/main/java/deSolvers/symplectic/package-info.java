/**
 * Symplectic methods: they step velocities ("kick") and positions ("drift") in turn instead of the state as a whole.
 *
 * <p>For a system without damping each of their steps conserves phase-space volume, and a quantity close to the energy,
 * the shadow energy: for x'' = -x and symplectic Euler, half of x<sup>2</sup> + v<sup>2</sup> - h x v. With linear
 * forces it is conserved exactly, otherwise up to an error that falls exponentially with 1/h. So a method of order p
 * keeps the true energy within order h<sup>p</sup>, without drift, however many steps are made, if they are short
 * compared with the period of the fastest motion. (With the slides' Euler, midpoint and RK4 the energy drifts.)
 *
 * <p>In a pendulum that swings to 2.9 rad (omega = 1), a million steps of verlet keep the energy within 0.0033 m g l at
 * h = 0.1 and within 0.086 m g l at h = 0.5. At h = 0.8 the pendulum goes over the top, though a linear spring is
 * stable up to h = 2.
 *
 * <p>All this is for forces that depend on positions alone. Rods and wires push with forces that grow with
 * v<sup>2</sup>: there none of these methods is symplectic, and the energy drifts as fast as their order lets it. A
 * pendulum of 1 m on a rod, from 60 degrees at h = 0.01 s, gains half of its energy in 20 s of symplectic Euler; verlet
 * loses 2 % in 200 s, and yoshida4 gains 0.1 %. With a force across the velocity, as that of a magnet, symplectic Euler
 * gains h<sup>2</sup> omega<sup>2</sup> of the kinetic energy in each step.
 *
 * <p>The price is a source that says which entries are positions and which are velocities
 * ({@link deSolvers.SecondOrderStateSource}), and a hard limit on the step: h omega &lt; 2, and 1.57 for yoshida4.
 *
 * <p>Reference: E. Hairer, C. Lubich, G. Wanner, <i>Geometric Numerical Integration</i>, 2nd ed., Springer 2006.
 */
package deSolvers.symplectic;
