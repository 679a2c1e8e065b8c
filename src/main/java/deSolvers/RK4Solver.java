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
    private double[] dSdt = {};
    private double[] trial = {};
    private double[] next = {};

    @Override
    public void stepState(DEStateSource client, double deltaT) {
        int n = client.getStateSize();
        if (next.length != n) {
            dSdt = new double[n];
            trial = new double[n];
            next = new double[n];
        }
        try (GuardedStep source = guard.begin(client, deltaT)) {
            double[] state = source.getStartState();
            double[] dSdt = this.dSdt;
            double[] trial = this.trial;
            double[] next = this.next;

            source.getStateDerivative(state, dSdt);     // at (s, t)
            for (int i = 0; i < n; i++) {
                double k1 = deltaT * dSdt[i];           // the Euler step
                next[i] = state[i] + 1.0 / 6 * k1;
                trial[i] = state[i] + k1 / 2;
            }
            source.incTime(deltaT / 2);

            source.getStateDerivative(trial, dSdt);     // at (s + k1/2, t + deltaT/2)
            for (int i = 0; i < n; i++) {
                double k2 = deltaT * dSdt[i];           // the midpoint step
                next[i] += 1.0 / 3 * k2;
                trial[i] = state[i] + k2 / 2;
            }

            source.getStateDerivative(trial, dSdt);     // at (s + k2/2, t + deltaT/2)
            for (int i = 0; i < n; i++) {
                double k3 = deltaT * dSdt[i];           // the refined midpoint step
                next[i] += 1.0 / 3 * k3;
                trial[i] = state[i] + k3;
            }
            source.incTime(deltaT / 2);

            source.getStateDerivative(trial, dSdt);     // at (s + k3, t + deltaT)
            for (int i = 0; i < n; i++) {
                double k4 = deltaT * dSdt[i];           // the refined refined step
                next[i] += 1.0 / 6 * k4;
            }
            double[] free = source.handOver(next);
            if (free != next) {                         // storing a reference costs the garbage collector's note
                this.next = free;
            }
        }
    }
}
