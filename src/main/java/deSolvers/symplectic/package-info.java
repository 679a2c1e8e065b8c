/**
 * Symplectic methods: they step positions and velocities in turn ("kick" and "drift") instead of the state as a whole.
 *
 * <p>For a system without damping each of their steps conserves phase-space volume, and a nearby "shadow" energy:
 * exactly where the forces are linear, and else up to an error that falls exponentially with 1/h. The true energy
 * therefore oscillates about its value with an amplitude of order h<sup>p</sup> and does not drift, however many steps
 * are made. With the slides' Euler, midpoint and RK4 it drifts. This holds if the steps are short compared with the
 * period of the fastest motion. In a pendulum that swings to 2.9 rad (omega = 1), a million steps of verlet keep the
 * energy within 0.0033 m g l at h = 0.1 and within 0.086 at h = 0.5; at h = 0.8 it goes over the top, though a linear
 * spring is stable up to 2.
 *
 * <p>The price is a source that says which entries are positions and which are velocities
 * ({@link deSolvers.SecondOrderStateSource}), and a hard limit on the step: h omega &lt; 2, and 1.57 for yoshida4.
 *
 * <p>Reference: E. Hairer, C. Lubich, G. Wanner, <i>Geometric Numerical Integration</i>, 2nd ed., Springer 2006.
 */
package deSolvers.symplectic;
