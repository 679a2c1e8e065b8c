package deSolvers.symplectic;

/**
 * Yoshida's method of fourth order: three leapfrogs, forward, backward and forward, so long that their errors cancel.
 * <pre>
 *   w1 = 1 / (2 - 2^(1/3)) = 1.3512...,    w0 = 1 - 2 w1 = -1.7024...
 *   s(t + h) = leapfrog(w1 h) after leapfrog(w0 h) after leapfrog(w1 h)
 * </pre>
 * Each leapfrog is half a kick, a drift, half a kick, as in {@link VelocityVerletSolver}, and its closing kick is solved
 * for the velocity where the acceleration depends on it.
 *
 * <p><b>Order</b> 4, also with drag and damping.<br>
 * <b>Evaluations</b> 3 a step (and 1 to start with); with drag or damping some more for the iteration.<br>
 * <b>Stability</b> an undamped spring for h omega &lt; 1.5734, less than {@code verlet} allows for a third of the work. Up
 * to there the energy error does not grow; on x'' = -x from (1, 0) it is 0.076 h<sup>4</sup> of the energy for small h.
 * Reversible.<br>
 * <b>When to use</b> long undamped motion whose path matters, orbits above all; not near the stability limit, where
 * {@code verlet} is cheaper, and not with strong damping, which its backward part would have to undo.<br>
 * <b>Source</b> H. Yoshida, <i>Construction of higher order symplectic integrators</i>, Phys. Lett. A 150 (1990) 262-268.
 */
public final class Yoshida4Solver extends KickDriftKick {
    private static final double W1 = 1 / (2 - StrictMath.cbrt(2));
    private static final double W0 = 1 - 2 * W1;

    /** A solver that has nothing to remember yet. */
    public Yoshida4Solver() {
        super(W1, W0, W1);
    }
}
