package deSolvers.symplectic;

import static deSolvers.symplectic.BlockLayout.kickDriftFromDerivative;

import deSolvers.DESolver;
import deSolvers.DEStateSource;
import deSolvers.GuardedStep;

/**
 * Symplectic Euler, the slides' "Simple Particle System Algorithm": the velocity first, then the position with the
 * <i>new</i> velocity.
 * <pre>
 *   v(t + h) = v(t) + h a(x(t), v(t), t)
 *   x(t + h) = x(t) + h v(t + h)
 * </pre>
 * One letter apart from the Euler method of the later slides, which uses the old velocity - and stable where that one
 * spirals out.
 *
 * <p><b>Order</b> 1.<br>
 * <b>Evaluations</b> 1 a step.<br>
 * <b>Stability</b> an undamped spring for h omega &lt; 2. On x'' = -x from (1, 0) the energy error stays below h/(2 - h) of
 * the energy for ever; the exact quadratic invariant is x<sup>2</sup> + v<sup>2</sup> - h x v.<br>
 * <b>When to use</b> games and first animations: one evaluation, robust; not where phase or amplitude matter, since
 * {@code verlet} costs the same and has order 2. It is not reversible.<br>
 * <b>Source</b> COMPSCI 715 (2003), slide "A Simple Particle System Algorithm"; R. de Vogelaere (1956).
 */
public final class SymplecticEulerSolver extends DESolver {
    private final GuardedStep guard = new GuardedStep(this);
    private double[] dSdt = {};
    private double[] next = {};

    @Override
    public void stepState(DEStateSource client, double deltaT) {
        int d = BlockLayout.of(this, client).getDimension();
        int n = client.getStateSize();
        if (next.length != n) {
            dSdt = new double[n];
            next = new double[n];
        }
        try (GuardedStep source = guard.begin(client, deltaT)) {
            double[] state = source.getStartState();
            double[] dSdt = this.dSdt;
            double[] next = this.next;
            source.getStateDerivative(state, dSdt);     // at (x, v, t)
            kickDriftFromDerivative(state, dSdt, n, d, deltaT, deltaT, next);
            double[] free = source.handOver(next);
            if (free != next) {                         // storing a reference costs the garbage collector's note
                this.next = free;
            }
        }
    }
}
