package deSolvers.symplectic;

import deSolvers.DEStateSource;

/**
 * The velocity Verlet (or leapfrog) method: half a kick, a drift, half a kick.
 * <pre>
 *   v(t + h/2) = v(t) + h/2 a(x(t), v(t), t)
 *   x(t + h)   = x(t) + h v(t + h/2)
 *   v(t + h)   = v(t + h/2) + h/2 a(x(t + h), v(t + h), t + h)
 * </pre>
 * The last line is solved for v(t + h) by fixed-point iteration where the acceleration depends on the velocity. The
 * acceleration at the end of a step is the one at the beginning of the next: it is remembered.
 *
 * <p><b>Order</b> 2, also with drag and damping.<br>
 * <b>Evaluations</b> 1 per step (and 1 to start with); some more where the acceleration depends on the velocity.<br>
 * <b>Stability</b> an undamped spring for h omega &lt; 2, a critically damped one for h omega &lt; 0.74, beyond which
 * the iteration fails. On x'' = -x from (1, 0) the energy error stays below h<sup>2</sup>/4 of the energy for ever.
 * Reversible: a step back leads to where the step began.<br>
 * <b>When to use</b> long undamped motion; the default of molecular dynamics and astronomy. Not with strong damping,
 * which needs an implicit solver; on rods and wires the energy drifts slowly.<br>
 * <b>Source</b> L. Verlet (1967); W. C. Swope et al. (1982), J. Chem. Phys. 76, 637.
 */
public final class VelocityVerletSolver extends SymplecticSolver {

    @Override
    void kickAndDrift(DEStateSource source, double[] s, double deltaT) {
        double[] a = startAcceleration(s);      // a(x(t), v(t), t)
        kick(s, a, deltaT / 2);                 // v(t + deltaT/2) = v(t) + deltaT/2 a
        drift(s, deltaT);                       // x(t + deltaT)   = x(t) + deltaT v(t + deltaT/2)
        source.incTime(deltaT);
        a = closingKick(s, a, deltaT / 2);      // v(t + deltaT)   = v(t + deltaT/2) + deltaT/2 a(t + deltaT)
        remember(s, a);
    }
}
