package deSolvers.adaptive;

import deSolvers.StepTransaction;
import deSolvers.rungeKutta.ButcherTableau;
import deSolvers.rungeKutta.RungeKuttaStages;

/**
 * The slides' adaptive step: "take two steps of &Delta;t, one step of 2 &Delta;t, compare results", with RK4 for both.
 * <pre>
 *   s2 = two steps of RK4,  s1 = one of twice the length:   error of s2 is about (s2 - s1) / 15
 * </pre>
 * since one long step errs by 2<sup>5</sup> and two short ones by 2 times a short step's error. The result of the two
 * steps is kept, as on the slide. (Many codes keep s2 + (s2 - s1)/15 instead, <i>local extrapolation</i>. Its order is
 * 5, but it is stable nowhere on the imaginary axis: more accurate is not more stable.)
 *
 * <p>For s' = lambda s and z = h lambda that estimate is 0 by chance at z = -10.98 and z = -2.51 &plusmn; 9.93 i, where
 * both results are far too large (436 times at the first), so that alone it takes such steps without end. A second one
 * is made of the four slopes that are there for the time of the middle,
 * <pre>
 *   (k2 + k3 of the long step + 4 k4 of the first short one - 6 f(s at the middle)) h / 240
 * </pre>
 * It is O(h<sup>5</sup>) as well, z<sup>5</sup>/15360, which is 0 nowhere else and an eighth of the first for small z:
 * it decides only where the first is 0 by chance. The larger of the two counts.
 *
 * <p><b>Order</b> 4.<br>
 * <b>Evaluations</b> 11 a double step (the first is shared), 10 for one that is tried again.<br>
 * <b>Stability</b> per double step z of the two RK4 steps, R(z) = R4(z/2)<sup>2</sup>: h |lambda| &le; 5.5706 on the
 * negative real axis, h omega &le; 5.6569 on the imaginary one.
 * A part of the solution that is too fast for the
 * steps, and has decayed, may come back to many times its tolerance (150 were measured, 19 with
 * {@code dormand-prince}).<br> <b>When to use</b> to see how a step is controlled; {@code dormand-prince} needs about
 * half the evaluations for the same error.<br>
 * <b>Source</b> COMPSCI 715 (2003), slide "Adaptive Stepsizes"; W. H. Press et al., <i>Numerical Recipes</i>, 2nd ed.,
 * section 16.2; the second estimate is our own.
 */
public final class StepDoublingSolver extends AdaptiveSolver {
    static final ButcherTableau RK4 = ButcherTableau.parse("""
              0  |
             1/2 | 1/2
             1/2 |  0   1/2
              1  |  0    0    1
             ----+--------------------
                 | 1/6  1/3  1/3  1/6
            """, 4);
    private static final double[] WEIGHTS = RK4.weights(0);

    private final RungeKuttaStages stages = new RungeKuttaStages(RK4);
    private double[] once = {};
    private double[] middle = {};
    private double[] middleSlope = {};
    private double[] error = {};
    private double[] middleError = {};

    /** With the tolerances {@value #RELATIVE_TOLERANCE} and {@value #ABSOLUTE_TOLERANCE}. */
    public StepDoublingSolver() {
        this(RELATIVE_TOLERANCE, ABSOLUTE_TOLERANCE);
    }

    /**
     * @param relativeTolerance error allowed for an entry of the state in one double step, relative to its size
     * @param absoluteTolerance error allowed besides, in the entry's unit
     * @throws IllegalArgumentException if one of them is negative or not finite, or both are 0
     */
    public StepDoublingSolver(double relativeTolerance, double absoluteTolerance) {
        super(relativeTolerance, absoluteTolerance);
    }

    @Override
    protected void resize(int n) {
        stages.resize(n);
        once = new double[n];
        middle = new double[n];
        middleSlope = new double[n];
        error = new double[n];
        middleError = new double[n];
    }

    @Override
    protected double attempt(StepTransaction source, double[] state, double[] slope, double offset, double h,
                             double[] newState) {
        rk4(source, state, slope, offset, h, once);                             // one step of 2 deltaT
        noteMiddle(stages.slope(1), stages.slope(2));
        rk4(source, state, slope, offset, h / 2, middle);                       // the first of two steps of deltaT
        source.setState(middle);
        source.setOffset(offset + h / 2);
        source.getStateDerivative(middleSlope);
        compareMiddle(stages.slope(3), h);
        rk4(source, middle, middleSlope, offset + h / 2, h / 2, newState);      // the second
        for (int i = 0; i < error.length; i++) {
            error[i] = Math.max(Math.abs(newState[i] - once[i]) / 15, Math.abs(middleError[i]));
        }
        return tolerance().ratio(error, state, newState);
    }

    /** k2 + k3 of the long step, both at the middle's time. */
    private void noteMiddle(double[] k2, double[] k3) {
        for (int i = 0; i < middleError.length; i++) {
            middleError[i] = k2[i] + k3[i];
        }
    }

    /**
     * Completes the second estimate by k4 of the first short step, which is at the middle's time too, and by f there.
     */
    private void compareMiddle(double[] k4, double h) {
        for (int i = 0; i < middleError.length; i++) {
            middleError[i] = h * (middleError[i] + 4 * k4[i] - 6 * middleSlope[i]) / 240;
        }
    }

    private void rk4(StepTransaction source, double[] from, double[] slope, double offset, double h, double[] to) {
        stages.evaluate(source, from, slope, offset, h);
        stages.combine(WEIGHTS, h, to);
        for (int i = 0; i < to.length; i++) {
            to[i] += from[i];
        }
    }

    @Override
    protected int errorExponent() {
        return 5;
    }
}
