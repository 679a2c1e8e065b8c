package deSolvers.symplectic;

import deSolvers.DEStateSource;

/**
 * Yoshida's method of fourth order: three leapfrogs, forward, backward and forward, with lengths
 * chosen so that their errors cancel.
 * <pre>
 *   w1 = 1 / (2 - 2^(1/3)) = 1.3512...,    w0 = 1 - 2 w1 = -1.7024...
 *   s(t + h) = leapfrog(w1 h) after leapfrog(w0 h) after leapfrog(w1 h)
 * </pre>
 * Each leapfrog is half a kick, a drift, half a kick, as in {@link VelocityVerletSolver}, and its closing kick is
 * solved for the velocity where the acceleration depends on it.
 *
 * <p><b>Order</b> 4, also with drag and damping. The leapfrogs reach 0.35 h beyond both ends of the step: where a force
 * or an anchor's motion begins exactly with a step, the order of that step may fall to 2.<br>
 * <b>Evaluations</b> 3 per step (and 1 to start with); some more where the acceleration depends on the velocity.<br>
 * <b>Stability</b> an undamped spring for h omega &lt; 1.5734, a shorter step than {@code verlet} allows, at three
 * times the work; a critically damped one for h omega &lt; 0.438. Below these limits the energy error does not grow; on
 * x'' = -x from (1, 0) it is 0.076 h<sup>4</sup> of the energy for small h. Reversible.<br>
 * <b>When to use</b> long undamped motion whose path matters, such as orbits. Not near the stability limit, where
 * {@code verlet} is cheaper, and not with strong damping, which acts as growth in its backward leapfrog.<br>
 * <b>Source</b> H. Yoshida, <i>Construction of higher order symplectic integrators</i>, Phys. Lett. A 150 (1990)
 * 262-268.
 */
public final class Yoshida4Solver extends SymplecticSolver {
    private static final double W1 = 1 / (2 - StrictMath.cbrt(2));
    private static final double W0 = 1 - 2 * W1;
    private static final double[] WEIGHTS = {W1, W0, W1};

    @Override
    void kickAndDrift(DEStateSource source, double[] s, double deltaT) {
        double[] a = startAcceleration(s);
        for (double w : WEIGHTS) {              // a leapfrog of length h
            double h = w * deltaT;
            kick(s, a, h / 2);                  // v(t + h/2) = v(t) + h/2 a(t)
            drift(s, h);                        // x(t + h)   = x(t) + h v(t + h/2)
            source.incTime(h);
            a = closingKick(s, a, h / 2);       // v(t + h)   = v(t + h/2) + h/2 a(t + h)
        }
        remember(s, a);
    }
}
