package deSolvers.adaptive;

import deSolvers.StepTransaction;
import deSolvers.rungeKutta.ButcherTableau;
import deSolvers.rungeKutta.RungeKuttaStages;

/**
 * The Runge-Kutta pair of Dormand and Prince: one result of order 5, one of order 4 from the same stages, and their
 * difference for an error estimate. The tableau is in the code below, as printed in the paper.
 *
 * <p>The solver continues with the result of order 5 (local extrapolation). The last stage is at the end of the
 * sub-step and is the first stage of the next one (FSAL).
 *
 * <p><b>Order</b> 5; the estimate is that of order 4.<br>
 * <b>Evaluations</b> 6 per sub-step, taken or rejected, and 2 to begin with.<br>
 * <b>Stability</b> R(z) = 1 + z + z<sup>2</sup>/2 + z<sup>3</sup>/6 + z<sup>4</sup>/24 + z<sup>5</sup>/120 +
 * z<sup>6</sup>/600: stable for h |lambda| &le; 3.3066 on the negative real axis and for h omega &le; 0.9972 on the
 * imaginary one, where an amplitude shrinks by the fraction (h omega)<sup>6</sup>/3600 a sub-step. On a stiff system
 * its sub-steps stay at these limits.<br>
 * <b>When to use</b> smooth motion to a stated accuracy, 1e-3 to 1e-8: the first choice among the adaptive solvers; not
 * for stiff springs ({@code radau}), and for the strictest tolerances {@code bulirsch-stoer} is cheaper.<br>
 * <b>Source</b> J. R. Dormand, P. J. Prince, <i>A family of embedded Runge-Kutta formulae</i>, J. Comp. Appl. Math. 6
 * (1980) 19-26.
 */
public final class DormandPrinceSolver extends AdaptiveSolver {
    static final ButcherTableau TABLEAU = ButcherTableau.parse("""
              0  |
             1/5 |       1/5
            3/10 |      3/40         9/40
             4/5 |     44/45       -56/15        32/9
             8/9 | 19372/6561 -25360/2187  64448/6561  -212/729
              1  |  9017/3168     -355/33  46732/5247    49/176   -5103/18656
              1  |     35/384           0    500/1113   125/192    -2187/6784     11/84
            -----+-------------------------------------------------------------------------
                 |     35/384           0    500/1113   125/192    -2187/6784     11/84     0
                 | 5179/57600           0  7571/16695   393/640 -92097/339200  187/2100  1/40
            """);

    private final RungeKuttaStages stages = new RungeKuttaStages(TABLEAU);
    private final double[] errorWeights = TABLEAU.weights(0);
    private double[] error = {};

    /** With the tolerances {@value #RELATIVE_TOLERANCE} and {@value #ABSOLUTE_TOLERANCE}. */
    public DormandPrinceSolver() {
        this(RELATIVE_TOLERANCE, ABSOLUTE_TOLERANCE);
    }

    /**
     * @param relativeTolerance error allowed for an entry of the state in one sub-step, relative to its size
     * @param absoluteTolerance error allowed besides, in the entry's unit
     * @throws IllegalArgumentException if one of them is negative or not finite, or both are 0
     */
    public DormandPrinceSolver(double relativeTolerance, double absoluteTolerance) {
        super(relativeTolerance, absoluteTolerance);
        double[] lower = TABLEAU.weights(1);
        for (int i = 0; i < lower.length; i++) {
            errorWeights[i] -= lower[i];
        }
    }

    @Override
    protected void resize(int n) {
        stages.resize(n);
        error = new double[n];
    }

    @Override
    protected double attempt(StepTransaction source, double[] state, double[] slope, double offset, double h,
                             double[] newState) {
        stages.evaluate(source, state, slope, offset, h);
        System.arraycopy(stages.getLastState(), 0, newState, 0, newState.length);  // the last row of a is b
        stages.combine(errorWeights, h, error);
        return getTolerance().ratio(error, state, newState);
    }

    @Override
    protected int errorExponent() {
        return 5;
    }

    @Override
    protected boolean endSlope(double[] newSlope) {
        System.arraycopy(stages.slope(6), 0, newSlope, 0, newSlope.length);
        return true;
    }
}
