package deSolvers.symplectic;

import deSolvers.DEStateSource;

/**
 * Symplectic Euler, the slides' "Simple Particle System Algorithm": the velocity first, then the position with the
 * <i>new</i> velocity.
 * <pre>
 *   v(t + h) = v(t) + h a(x(t), v(t), t)
 *   x(t + h) = x(t) + h v(t + h)
 * </pre>
 * One line differs from the Euler method of the later slides, which moves with the old velocity: this one is stable
 * where that one spirals out. (The slide's loop moves the clock first; here, as usual, forces are those at t.)
 *
 * <p><b>Order</b> 1.<br>
 * <b>Evaluations</b> 1 per step.<br>
 * <b>Stability</b> an undamped spring for h omega &lt; 2, a critically damped one for h omega &lt; 0.8284. On x'' = -x
 * from (1, 0) the energy error stays below h/(2 - h) of the energy for ever; x<sup>2</sup> + v<sup>2</sup> - h x v
 * stays exactly the same.<br>
 * <b>When to use</b> games and first animations: one evaluation, robust; not where phase or amplitude matter, since
 * {@code verlet} costs the same and has order 2, nor on rods and wires, where the energy grows. It is not
 * reversible.<br>
 * <b>Source</b> COMPSCI 715 (2003), slide "A Simple Particle System Algorithm"; R. de Vogelaere (1956).
 */
public final class SymplecticEulerSolver extends SymplecticSolver {

    @Override
    void kickAndDrift(DEStateSource source, double[] s, double deltaT) {
        double[] a = derivative(s);             // a(x(t), v(t), t)
        kick(s, a, deltaT);                     // v(t + deltaT) = v(t) + deltaT a
        drift(s, deltaT);                       // x(t + deltaT) = x(t) + deltaT v(t + deltaT)
    }
}
