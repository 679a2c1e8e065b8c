package deSolvers.multistep;

import deSolvers.DEStateSource;
import deSolvers.FixedStepSolver;
import deSolvers.LastStep;

/**
 * The Adams-Bashforth-Moulton predictor-corrector method of fourth order: the derivatives of the last four steps
 * predict the new state, and the derivative there corrects it.
 * <pre>
 *   predict  p      = s + h/24 (55 f_0 - 59 f_1 + 37 f_2 -  9 f_3)       f_j: the derivative j steps ago
 *   evaluate f_new  = f(p, t + h)
 *   correct  s(t+h) = s + h/24 ( 9 f_new + 19 f_0 - 5 f_1 +  f_2)
 *   evaluate f_0 at the corrected state, when the next step begins
 * </pre>
 * The first three steps are RK4, and so are the three after a restart. It restarts whenever source, state, time or
 * deltaT differ from those at the end of the last step.
 *
 * <p><b>Order</b> 4.<br>
 * <b>Evaluations</b> 2 per step; 4 in each of the first three.<br>
 * <b>Stability</b> h |lambda| &le; 1.2848 on the negative real axis; unstable on the imaginary axis, though there
 * the growth is only 1.6e-7 per step at h omega = 0.1 and 1.5e-3 at 0.5.<br>
 * <b>When to use</b> costly derivatives and smooth motion at a fixed deltaT: half the evaluations of {@code rk4} for a
 * step of the same length, at less than half the stable length; not where bounces and contacts restart it again and
 * again, nor for long undamped oscillation.<br>
 * <b>Source</b> the slides quote W. H. Press et al., <i>Numerical Recipes</i>, on predictor-corrector methods (2nd ed.,
 * section 16.7); F. Bashforth, J. C. Adams (1883), F. R. Moulton (1926).
 */
public final class AdamsBashforthMoultonSolver extends FixedStepSolver {
    private final LastStep lastStep = new LastStep();
    private double[] f1 = {};                           // the derivative one step ago
    private double[] f2 = {};
    private double[] f3 = {};
    private int known;                                  // how many of them there are

    @Override
    protected void step(DEStateSource source, double[] s, double h) {
        if (!lastStep.continuesFrom(getTransaction())) {
            begin(s.length);
        }
        double[] f0 = derivative(s);                    // at (s, t)
        if (known < 3) {
            rungeKuttaStep(source, s, f0, h);
            known++;
        } else {
            predictAndCorrect(source, s, f0, h);
        }
        shiftHistory(f0);
        lastStep.keep(getTransaction(), s);
    }

    @Override
    public void reset() {
        lastStep.forget();
    }

    private void predictAndCorrect(DEStateSource source, double[] s, double[] f0, double h) {
        double[] p = copy(s);
        for (int i = 0; i < s.length; i++) {
            p[i] += h / 24 * (55 * f0[i] - 59 * f1[i] + 37 * f2[i] - 9 * f3[i]);
        }
        source.incTime(h);
        double[] fNew = derivative(p);                  // at (p, t + h)
        for (int i = 0; i < s.length; i++) {
            s[i] += h / 24 * (9 * fNew[i] + 19 * f0[i] - 5 * f1[i] + f2[i]);
        }
    }

    /** One step of RK4; f0 is its first derivative. */
    private void rungeKuttaStep(DEStateSource source, double[] s, double[] f0, double h) {
        source.incTime(h / 2);
        double[] g = derivative(plus(s, h / 2, f0));    // at (s + h/2 f0, t + h/2)
        double[] gRefined = derivative(plus(s, h / 2, g));
        source.incTime(h / 2);
        double[] fNew = derivative(plus(s, h, gRefined));
        for (int i = 0; i < s.length; i++) {
            s[i] += h / 6 * (f0[i] + 2 * (g[i] + gRefined[i]) + fNew[i]);
        }
    }

    private void begin(int n) {
        known = 0;
        if (f1.length != n) {
            f1 = new double[n];
            f2 = new double[n];
            f3 = new double[n];
        }
    }

    /** Shifts the history by one step. */
    private void shiftHistory(double[] f0) {
        double[] oldest = f3;
        f3 = f2;
        f2 = f1;
        f1 = oldest;
        System.arraycopy(f0, 0, f1, 0, f0.length);
    }
}
