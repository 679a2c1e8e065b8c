package deSolvers.multistep;

import deSolvers.DESolver;
import deSolvers.DEStateSource;
import deSolvers.GuardedStep;
import deSolvers.StepMemory;

/**
 * The predictor-corrector method of Adams, Bashforth and Moulton, fourth order: the derivatives of the last four steps
 * predict the new state, and the derivative there corrects it.
 * <pre>
 *   predict  p      = s + h/24 (55 f_0 - 59 f_1 + 37 f_2 -  9 f_3)       f_j: the derivative j steps ago
 *   evaluate f_new  = f(p, t + h)
 *   correct  s(t+h) = s + h/24 ( 9 f_new + 19 f_0 - 5 f_1 +  f_2)
 *   evaluate f_0 at the corrected state, when the next step begins
 * </pre>
 * The first three steps of a course are RK4. A new course begins whenever state, time, deltaT or source are not what the
 * last step left.
 *
 * <p><b>Order</b> 4.<br>
 * <b>Evaluations</b> 2 a step; 4 in each of the first three.<br>
 * <b>Stability</b> h |lambda| &le; 1.28 on the negative real axis; nothing on the imaginary axis, though there the growth
 * is only 1.6e-7 a step at h omega = 0.1 and 1.5e-3 at 0.5.<br>
 * <b>When to use</b> costly derivatives and smooth motion at a fixed deltaT: half the evaluations of {@code rk4} for a
 * step of the same length, at less than half the stable length; not where bounces and contacts restart it again and
 * again, nor for long undamped oscillation.<br>
 * <b>Source</b> the slides name predictor-corrector methods after W. H. Press et al., <i>Numerical Recipes</i>, 2nd ed.,
 * section 16.7; F. Bashforth, J. C. Adams (1883), F. R. Moulton (1926).
 */
public final class AdamsBashforthMoultonSolver extends DESolver {
    private static final int HISTORY = 3;               // derivatives of earlier steps that the predictor needs

    private final GuardedStep guard = new GuardedStep(this);
    private final StepMemory memory = new StepMemory();
    private int known;                                  // how many of f1, f2, f3 are there
    private double[] state = {};
    private double[] trial = {};
    private double[] f0 = {};
    private double[] f1 = {};
    private double[] f2 = {};
    private double[] f3 = {};
    private double[] fNew = {};
    private double[] k2 = {};
    private double[] k3 = {};

    @Override
    public void stepState(DEStateSource client, double deltaT) {
        int n = client.getStateSize();
        if (state.length != n) {
            resize(n);
        }
        try (GuardedStep source = guard.begin(client, deltaT)) {
            if (!memory.takeUp(client, source.getStartTime(), source.getStartState(), deltaT, state)) {
                known = 0;
            }
            source.getState(state);
            source.getStateDerivative(f0);              // at (s, t), which the last step left
            if (known < HISTORY) {
                startWithRK4(source, deltaT);
                known++;
            } else {
                predictAndCorrect(source, deltaT);
            }
            source.finish(state);
            memory.keep(client, source.getEndTime(), deltaT);
            shiftHistory();
        }
    }

    private void resize(int n) {
        state = new double[n];
        trial = new double[n];
        f0 = new double[n];
        f1 = new double[n];
        f2 = new double[n];
        f3 = new double[n];
        fNew = new double[n];
        k2 = new double[n];
        k3 = new double[n];
        memory.forget();
    }

    private void predictAndCorrect(GuardedStep source, double h) {
        for (int i = 0; i < state.length; i++) {
            trial[i] = state[i] + h / 24 * (55 * f0[i] - 59 * f1[i] + 37 * f2[i] - 9 * f3[i]);
        }
        derivativeAt(source, h, fNew);                  // at (p, t + h)
        for (int i = 0; i < state.length; i++) {
            state[i] += h / 24 * (9 * fNew[i] + 19 * f0[i] - 5 * f1[i] + f2[i]);
        }
    }

    /** One step of RK4; f0 is its first slope. */
    private void startWithRK4(GuardedStep source, double h) {
        for (int i = 0; i < state.length; i++) {
            trial[i] = state[i] + h / 2 * f0[i];
        }
        derivativeAt(source, h / 2, k2);                // at (s + h f0/2, t + h/2)
        for (int i = 0; i < state.length; i++) {
            trial[i] = state[i] + h / 2 * k2[i];
        }
        derivativeAt(source, h / 2, k3);                // at (s + h k2/2, t + h/2)
        for (int i = 0; i < state.length; i++) {
            trial[i] = state[i] + h * k3[i];
        }
        derivativeAt(source, h, fNew);                  // at (s + h k3, t + h)
        for (int i = 0; i < state.length; i++) {
            state[i] += h / 6 * (f0[i] + 2 * (k2[i] + k3[i]) + fNew[i]);
        }
    }

    private void derivativeAt(GuardedStep source, double offset, double[] dSdt) {
        source.setState(trial);
        source.setOffset(offset);
        source.getStateDerivative(dSdt);
    }

    /** What was the derivative now is that of one step ago; the oldest array is used again. */
    private void shiftHistory() {
        double[] oldest = f3;
        f3 = f2;
        f2 = f1;
        f1 = f0;
        f0 = oldest;
    }

    @Override
    public void reset() {
        memory.forget();
    }
}
