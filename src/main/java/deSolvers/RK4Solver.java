package deSolvers;

/**
 * The classical Runge-Kutta method of fourth order, "for ploughing the fields".
 * <pre>
 *    0  |
 *   1/2 | 1/2
 *   1/2 |  0   1/2
 *    1  |  0    0    1
 *   ----+--------------------
 *       | 1/6  1/3  1/3  1/6
 * </pre>
 * <b>Order</b> 4.<br>
 * <b>Evaluations</b> 4 a step.<br>
 * <b>Stability</b> R(z) = 1 + z + z<sup>2</sup>/2 + z<sup>3</sup>/6 + z<sup>4</sup>/24: stable for h |lambda| &le; 2.7853 on
 * the negative real axis and for h omega &le; 2.8284 on the imaginary axis, where it damps by (h omega)<sup>6</sup>/144 a
 * step.<br>
 * <b>When to use</b> smooth motion and whenever in doubt; not for stiff springs, and not for very long undamped runs,
 * where its small damping adds up and {@code verlet} or {@code yoshida4} keep the energy.<br>
 * <b>Source</b> COMPSCI 715 (2003), slide "4th-Order Runge-Kutta Algorithm"; W. Kutta (1901).
 */
public final class RK4Solver extends DESolver {
    private final GuardedStep guard = new GuardedStep(this);
    private double[] state = {};
    private double[] trial = {};
    private double[] k1 = {};
    private double[] k2 = {};
    private double[] k3 = {};
    private double[] k4 = {};

    @Override
    public void stepState(DEStateSource client, double deltaT) {
        int n = client.getStateSize();
        if (state.length != n) {
            state = new double[n];
            trial = new double[n];
            k1 = new double[n];
            k2 = new double[n];
            k3 = new double[n];
            k4 = new double[n];
        }
        try (GuardedStep source = guard.begin(client, deltaT)) {
            source.getState(state);

            source.getStateDerivative(k1);              // at (s, t): the Euler step
            for (int i = 0; i < n; i++) {
                k1[i] *= deltaT;
                trial[i] = state[i] + k1[i] / 2;
            }
            source.setState(trial);
            source.incTime(deltaT / 2);

            source.getStateDerivative(k2);              // at (s + k1/2, t + deltaT/2): the midpoint step
            for (int i = 0; i < n; i++) {
                k2[i] *= deltaT;
                trial[i] = state[i] + k2[i] / 2;
            }
            source.setState(trial);

            source.getStateDerivative(k3);              // at (s + k2/2, t + deltaT/2): the refined midpoint step
            for (int i = 0; i < n; i++) {
                k3[i] *= deltaT;
                trial[i] = state[i] + k3[i];
            }
            source.setState(trial);
            source.incTime(deltaT / 2);

            source.getStateDerivative(k4);              // at (s + k3, t + deltaT): the refined refined step
            for (int i = 0; i < n; i++) {
                k4[i] *= deltaT;
                state[i] += 1.0 / 6 * k1[i] + 1.0 / 3 * k2[i] + 1.0 / 3 * k3[i] + 1.0 / 6 * k4[i];
            }
            source.finish(state);
        }
    }
}
