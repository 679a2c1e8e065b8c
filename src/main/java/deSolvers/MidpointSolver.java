package deSolvers;

/**
 * The mid-point method, a Runge-Kutta method of second order: an Euler step shows where the middle of the step is, and
 * the derivative there makes the step.
 * <pre>
 *    0  |
 *   1/2 | 1/2
 *   ----+---------
 *       |  0    1
 * </pre>
 * <b>Order</b> 2.<br>
 * <b>Evaluations</b> 2 a step.<br>
 * <b>Stability</b> R(z) = 1 + z + z<sup>2</sup>/2: stable for h |lambda| &le; 2 on the negative real axis, nowhere on the
 * imaginary axis; there the growth is only (h omega)<sup>4</sup>/8 a step, so it shows late.<br>
 * <b>When to use</b> short or damped animations where a second evaluation buys a lot; not for long undamped
 * oscillation, where {@code verlet} costs half and does not grow.<br>
 * <b>Source</b> COMPSCI 715 (2003), slides "Mid-point Method" to "Mid-point method: Algorithm (cont'd)".
 */
public final class MidpointSolver extends DESolver {
    private final GuardedStep guard = new GuardedStep(this);
    private double[] dSdt = {};
    private double[] mid = {};
    private double[] gMid = {};
    private double[] next = {};

    @Override
    public void stepState(DEStateSource client, double deltaT) {
        int n = client.getStateSize();
        if (next.length != n) {
            dSdt = new double[n];
            mid = new double[n];
            gMid = new double[n];
            next = new double[n];
        }
        try (GuardedStep source = guard.begin(client, deltaT)) {
            double[] state = source.getStartState();
            double[] dSdt = this.dSdt;
            double[] mid = this.mid;
            double[] gMid = this.gMid;
            double[] next = this.next;
            source.getStateDerivative(state, dSdt);     // at (s, t)
            for (int i = 0; i < n; i++) {
                double deltaS = deltaT * dSdt[i];       // the Euler step
                mid[i] = state[i] + deltaS / 2;
            }
            source.incTime(deltaT / 2);
            source.getStateDerivative(mid, gMid);       // at (s + deltaS/2, t + deltaT/2)
            for (int i = 0; i < n; i++) {
                next[i] = state[i] + deltaT * gMid[i];
            }
            double[] free = source.handOver(next);
            if (free != next) {                         // storing a reference costs the garbage collector's note
                this.next = free;
            }
        }
    }
}
