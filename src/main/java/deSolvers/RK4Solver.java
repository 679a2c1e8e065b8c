package deSolvers;

/**
 * The classical Runge-Kutta method of fourth order (RK4): four Euler steps from different points, and their weighted
 * mean.
 * <pre>
 *    0  |
 *   1/2 | 1/2
 *   1/2 |  0   1/2
 *    1  |  0    0    1
 *   ----+--------------------
 *       | 1/6  1/3  1/3  1/6
 * </pre>
 * <b>Order</b> 4.<br>
 * <b>Evaluations</b> 4 per step.<br>
 * <b>Stability</b> R(z) = 1 + z + z<sup>2</sup>/2 + z<sup>3</sup>/6 + z<sup>4</sup>/24: stable for h |lambda| &le;
 * 2.7853 on the negative real axis and for h omega &le; 2.8284 on the imaginary axis. If h omega is small, the
 * amplitude of an undamped spring shrinks by the fraction (h omega)<sup>6</sup>/144 a step.<br>
 * <b>When to use</b> smooth motion and whenever in doubt: in the slides' words, "for ploughing the fields". Not for
 * stiff springs, and not for very long undamped runs, where its small damping adds up and {@code verlet} or
 * {@code yoshida4} keep the energy.<br>
 * <b>Source</b> COMPSCI 715 (2003), slide "4th-Order Runge-Kutta Algorithm"; W. Kutta (1901).
 */
public final class RK4Solver extends FixedStepSolver implements SumOfDerivatives {

    @Override
    protected void step(DEStateSource source, double[] s, double deltaT) {
        double[] k1 = eulerStep(s, deltaT);                     // deltaT f(s, t)
        source.incTime(deltaT / 2);
        double[] k2 = eulerStep(plus(s, 0.5, k1), deltaT);      // deltaT f(s + k1/2, t + deltaT/2)
        double[] k3 = eulerStep(plus(s, 0.5, k2), deltaT);      // deltaT f(s + k2/2, t + deltaT/2)
        source.incTime(deltaT / 2);
        double[] k4 = eulerStep(plus(s, 1, k3), deltaT);        // deltaT f(s + k3, t + deltaT)
        for (int i = 0; i < s.length; i++) {
            s[i] = s[i] + 1.0 / 6 * k1[i] + 1.0 / 3 * k2[i] + 1.0 / 3 * k3[i] + 1.0 / 6 * k4[i];
        }
    }
}
