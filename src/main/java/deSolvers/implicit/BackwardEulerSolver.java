package deSolvers.implicit;

import deSolvers.DEStateSource;
import deSolvers.FixedStepSolver;
import deSolvers.linear.SolverWork;

/**
 * The backward Euler method: one straight step along the derivative at its <i>end</i>,
 * s(t + h) = s(t) + h f(s(t + h), t + h).
 * <pre>
 *    1 | 1
 *   ---+---
 *      | 1
 * </pre>
 * {@link Newton} solves the equation to 1e-10 of each entry of the state or to round-off, or an exception says that it
 * did not.
 * {@link LinearisedEulerSolver} takes the first of Newton's corrections only.
 *
 * <p><b>Order</b> 1.<br>
 * <b>Evaluations</b> a few a step for Newton's method. More, if the source does not know its own Jacobian ({@link
 * deSolvers.JacobianStateSource}): n for each Jacobian, and for particles on rods or wires, or balls in
 * contact, about 30 a step.<br>
 * <b>Stability</b> R(z) = 1/(1 - z): L-stable, no limit on the step for anything that decays or oscillates. Stable does
 * not mean accurate: the amplitude of an undamped spring shrinks by the factor (1 + (h
 * omega)<sup>2</sup>)<sup>-1/2</sup> a step.<br>
 * <b>When to use</b> stiff springs and strong damping where only the slow motion matters: cloth at frame rate. Not
 * where energy has to be conserved ({@code implicit-midpoint}) or accuracy counts ({@code radau}).<br>
 * <b>Source</b> C. F. Curtiss, J. O. Hirschfelder (1952), Proc. Nat. Acad. Sci. 38, 235.
 */
public final class BackwardEulerSolver extends FixedStepSolver {
    private final Newton newton = new Newton();

    @Override
    protected void step(DEStateSource source, double[] s, double deltaT) {
        source.incTime(deltaT);
        newton.solve(getTransaction(), copy(s), deltaT, s);             // s = s(t) + h f(s, t + h)
    }

    /** @return the work of all steps so far */
    public SolverWork getWork() {
        return newton.getWork();
    }
}
