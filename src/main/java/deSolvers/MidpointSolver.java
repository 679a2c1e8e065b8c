package deSolvers;

/**
 * The mid-point method, a Runge-Kutta method of second order: half an Euler step leads to the middle of the step, and
 * the derivative there is used for the whole step.
 * <pre>
 *    0  |
 *   1/2 | 1/2
 *   ----+---------
 *       |  0    1
 * </pre>
 * <b>Order</b> 2.<br>
 * <b>Evaluations</b> 2 per step.<br>
 * <b>Stability</b> R(z) = 1 + z + z<sup>2</sup>/2: stable for h |lambda| &le; 2 on the negative real axis, nowhere on
 * the imaginary axis. If h omega is small, the amplitude of an undamped spring grows by the fraction
 * (h omega)<sup>4</sup>/8 per step, which takes many steps to show.<br>
 * <b>When to use</b> short or damped animations where a second evaluation buys a lot; not for long undamped
 * oscillation, where {@code verlet} costs half and does not grow.<br>
 * <b>Source</b> COMPSCI 715 (2003), slides "Mid-point Method" to "Mid-point method: Algorithm (cont'd)".
 */
public final class MidpointSolver extends FixedStepSolver implements SumOfDerivatives.AfterTheFirst {

    @Override
    protected void step(DEStateSource source, double[] s, double deltaT) {
        double[] deltaS = eulerStep(s, deltaT);                 // at (s, t)
        source.incTime(deltaT / 2);
        double[] gMid = derivative(plus(s, 0.5, deltaS));       // at (s + deltaS/2, t + deltaT/2)
        for (int i = 0; i < s.length; i++) {
            s[i] += deltaT * gMid[i];
        }
    }
}
