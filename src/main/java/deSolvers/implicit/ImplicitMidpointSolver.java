package deSolvers.implicit;

import deSolvers.DEStateSource;
import deSolvers.FixedStepSolver;
import deSolvers.linear.SolverWork;

/**
 * The implicit midpoint rule: one straight step along the derivative at the middle of itself,
 * s(t + h) = s(t) + h f((s(t) + s(t + h))/2, t + h/2).
 * <pre>
 *   1/2 | 1/2
 *   ----+-----
 *       |  1
 * </pre>
 * Its middle m solves the backward Euler equation of half a step, m = s + h/2 f(m, t + h/2); the other half continues
 * along the same line, s(t + h) = 2 m - s. {@link Newton} solves to 1e-10 of each entry of the state or to round-off,
 * or an exception says that it did not.
 *
 * <p><b>Order</b> 2.<br>
 * <b>Evaluations</b> as for {@code backward-euler}.<br>
 * <b>Stability</b> R(z) = (1 + z/2)/(1 - z/2): no limit on the step for anything that decays or oscillates. |R| = 1 on
 * the imaginary axis, so linear springs keep their energy; but R(-infinity) = -1, so a component that should decay at
 * once keeps alternating in sign instead. If the equation has several solutions, the solver takes the one near the
 * present state; that keeps a spring that is very stiff for the step from turning inside out.<br>
 * <b>When to use</b> stiff oscillation whose energy matters: it is symplectic and reversible. Not for stiff damping,
 * where {@code backward-euler} is calmer. Nor for undamped springs that turn, as in cloth, unless the step resolves
 * them: stability for linear springs is none for nonlinear ones, and symplecticity does not bound the energy of long
 * steps. In 1 s, a hanging cloth of 400 particles gained 4.8 times its energy at 1/60 s, and 2 % at 0.004 s.<br>
 * <b>Source</b> Gauss-Legendre collocation with one stage, J. C. Butcher (1964), Math. Comp. 18, 50; its blow-up: J. C.
 * Simo and O. Gonzalez (1993), Assessment of energy-momentum and symplectic schemes for stiff dynamical systems, ASME.
 */
public final class ImplicitMidpointSolver extends FixedStepSolver {
    private final Newton newton = new Newton();

    @Override
    protected void step(DEStateSource source, double[] s, double deltaT) {
        source.incTime(deltaT / 2);
        double[] mid = copy(s);
        newton.solve(getTransaction(), s, deltaT / 2, mid);              // mid = s + h/2 f(mid, t + h/2)
        for (int i = 0; i < s.length; i++) {
            s[i] = 2 * mid[i] - s[i];
        }
    }

    /** @return the work of all steps so far */
    public SolverWork getWork() {
        return newton.getWork();
    }
}
