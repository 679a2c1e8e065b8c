package deSolvers.adaptive;

import deSolvers.StepTransaction;
import deSolvers.rungeKutta.ButcherTableau;
import deSolvers.rungeKutta.RungeKuttaStages;

/**
 * The slides' adaptive step: "take two steps of &Delta;t, one step of 2 &Delta;t, compare results", with RK4 for both.
 * Here h is the length of a sub-step, the slide's 2 &Delta;t:
 * <pre>
 *   s1 = one RK4 step of h,  s2 = two RK4 steps of h/2:     error of s2 is about (s2 - s1) / 15
 * </pre>
 * since the long step errs by 2<sup>5</sup> times, and the two short ones together by 2 times, the error of a short
 * step. The result of the two short steps is kept. (Many codes keep s2 + (s2 - s1)/15 instead,
 * <i>local extrapolation</i>. Its order is 5, but it is stable nowhere on the imaginary axis: more accurate is not more
 * stable.)
 *
 * <p>At a few step lengths, far beyond the stability limit, the two results agree by accident although both are wrong.
 * A second estimate, from slopes that are known in the middle of the sub-step, catches these; in small steps it decides
 * nothing, and a reader may skip it.
 *
 * <p><b>Order</b> 4.<br>
 * <b>Evaluations</b> 11 per sub-step (the two methods share the first), 10 for one that is tried again.<br>
 * <b>Stability</b> a sub-step has R(z) = R4(z/2)<sup>2</sup>, with R4 that of RK4: h |lambda| &le; 5.5706 on the
 * negative real axis, h omega &le; 5.6569 on the imaginary one. A fast vibration that has decayed may grow again, in
 * our tests up to 150 times its tolerance (19 with {@code dormand-prince}).<br>
 * <b>When to use</b> to see how a step is controlled; {@code dormand-prince} needs a
 * quarter to a half of the evaluations for the same error.<br>
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
            """);
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
     * @param relativeTolerance error allowed for an entry of the state in one sub-step, relative to its size
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
        rk4(source, state, slope, offset, h, once);                             // one long step
        noteMiddle(stages.slope(1), stages.slope(2));
        rk4(source, state, slope, offset, h / 2, middle);                       // the first short step
        source.setState(middle);
        source.setOffset(offset + h / 2);
        source.getStateDerivative(middleSlope);
        compareMiddle(stages.slope(3), h);
        rk4(source, middle, middleSlope, offset + h / 2, h / 2, newState);      // the second short step
        for (int i = 0; i < error.length; i++) {
            error[i] = Math.max(Math.abs(newState[i] - once[i]) / 15, Math.abs(middleError[i]));
        }
        return getTolerance().ratio(error, state, newState);
    }

    /** k2 + k3 of the long step, both at the middle's time. */
    private void noteMiddle(double[] k2, double[] k3) {
        for (int i = 0; i < middleError.length; i++) {
            middleError[i] = k2[i] + k3[i];
        }
    }

    /**
     * The second estimate, (k2 + k3 of the long step + 4 k4 of the first short one - 6 f(s at the middle)) h / 240,
     * from four slopes at the same time. For s' = lambda s and z = h lambda its size is |z|^5/15360, an eighth of the
     * first where z is small. The first is 0 by accident at z = -10.98 and z = -2.51 +- 9.93 i; this one is not.
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
