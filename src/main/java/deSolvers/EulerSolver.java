package deSolvers;

/**
 * The Euler method: one straight step along the derivative, s(t + h) = s(t) + h f(s(t), t).
 * {@link FixedStepSolver} reads the state before the step; after it, it writes the state back and sets the clock to
 * t + h. In the small table of a method, as RK4's, the numbers before the bar are the times, as parts of h, at which it
 * evaluates f; below the line are the weights of these derivatives in the new state. (More: package {@code deSolvers}.)
 * <pre>
 *    0 |
 *   ---+---
 *      | 1
 * </pre>
 * <b>Order</b> 1: the error of a step is O(h<sup>2</sup>); the error after a given time is proportional to h.<br>
 * <b>Evaluations</b> 1 per step.<br>
 * <b>Stability</b> R(z) = 1 + z, the factor of a step of s' = lambda s with z = h lambda: stable for h |lambda| &le; 2
 * on the negative real axis and nowhere on the imaginary axis. The amplitude of an undamped spring grows by the factor
 * (1 + (h omega)<sup>2</sup>)<sup>1/2</sup> a step, however small h is.<br>
 * <b>When to use</b> to see why the others exist, and for smooth, strongly damped systems; not for anything
 * that oscillates. "An Euler solver is too horrible. NEVER use it. Yeah I know you will anyway."<br>
 * <b>Source</b> COMPSCI 715 (2003), slides "The Euler Method" and "Euler Solver Code".
 */
public final class EulerSolver extends FixedStepSolver implements SumOfDerivatives {

    @Override
    protected void step(DEStateSource source, double[] state, double deltaT) {
        double[] dSdt = derivative(state);              // at (s, t)
        for (int i = 0; i < state.length; i++) {
            state[i] += dSdt[i] * deltaT;
        }
    }
}
