/**
 * Symplectic methods: they step positions and velocities in turn ("kick" and "drift") instead of the state as a whole.
 *
 * <p>For a system without damping each of their steps conserves phase-space volume, and a nearby "shadow" energy
 * exactly. The true energy therefore oscillates about its value with an amplitude of order h<sup>p</sup> and does not
 * drift, however long the run: what the slides' Euler, midpoint and RK4 cannot do. The price is a source that says
 * which entries are positions and which are velocities ({@link deSolvers.SecondOrderStateSource}) and a hard limit
 * h omega &lt; 2 on the step.
 *
 * <p>Reference: E. Hairer, C. Lubich, G. Wanner, <i>Geometric Numerical Integration</i>, 2nd ed., Springer 2006.
 */
package deSolvers.symplectic;
