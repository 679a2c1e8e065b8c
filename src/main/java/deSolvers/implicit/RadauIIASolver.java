package deSolvers.implicit;

import deSolvers.StepTransaction;
import deSolvers.adaptive.AdaptiveSolver;
import deSolvers.linear.SolverWork;

/**
 * The Radau IIA method with three stages, an implicit Runge-Kutta method of order 5. Its solution in a sub-step is the
 * polynomial of degree 3 that satisfies the differential equation at three times, the last of them the end of the
 * sub-step (collocation). With q the square root of 6:
 * <pre>
 *   (4 - q)/10 | (88 - 7q)/360       (296 - 169q)/1800   (-2 + 3q)/225
 *   (4 + q)/10 | (296 + 169q)/1800   (88 + 7q)/360       (-2 - 3q)/225
 *       1      | (16 - q)/36         (16 + q)/36          1/9
 *   -----------+-----------------------------------------------------
 *              | (16 - q)/36         (16 + q)/36          1/9
 * </pre>
 * The stages are found by a simplified Newton iteration to a hundredth of the tolerance. The Jacobian is kept as long
 * as that converges fast, the factorised matrices as long as the sub-step stays the same. The estimate of the error
 * uses one more, explicit stage, and is filtered through the real matrix, so that stiff components do not spoil it.
 *
 * <p><b>Order</b> 5; on very stiff components 3, the order of the stages. The estimate is of order 3.<br>
 * <b>Evaluations</b> 3 for each iteration, most often 2 to 4 iterations a sub-step, and 1 more; n more for each
 * Jacobian where the source does not know its own ({@link deSolvers.JacobianStateSource}).<br>
 * <b>Stability</b> L-stable, R(z) = (1 + 2z/5 + z<sup>2</sup>/20)/(1 - 3z/5 + 3z<sup>2</sup>/20 - z<sup>3</sup>/60): no
 * limit on the step for anything that decays or oscillates.<br>
 * <b>When to use</b> stiff systems to a stated accuracy, 1e-3 to 1e-10: the reference to compare others with. For
 * smooth motion {@code dormand-prince} is cheaper; for a large cloth that only has to look right, {@code
 * backward-euler}: one of 32 x 32 particles takes radau about ten seconds for each second of its fall.<br>
 * <b>Source</b> E. Hairer, G. Wanner, <i>Solving Ordinary Differential Equations II</i>, 2nd ed., Springer 1996,
 * sections IV.5 and IV.8.
 */
public final class RadauIIASolver extends AdaptiveSolver {
    /** A Jacobian is old when Newton's iteration with it gains less than three digits a time. */
    private static final double SLOW_RATE = 1e-3;
    private static final double MOST_SHRINKING = 0.2;
    private static final double MOST_GROWTH = 10;
    /** Sub-steps that would grow by less than this stay the same, and keep their factorised matrices. */
    private static final double WORTH_FACTORISING = 1.2;

    private final SolverWork work = new SolverWork();
    private final JacobianChoice choice = new JacobianChoice(work);
    private ShiftedJacobian jacobian;
    private RadauNewton newton = new RadauNewton(work, getTolerance(), 0);
    private double[][] z = new double[3][0];
    private double[][] polynomial = new double[3][0];  // of the last sub-step taken: coefficients of u, u^2, u^3
    private double[] error = {};
    private double[] right = {};
    private double[] shifted = {};
    private boolean jacobianKnown;
    private boolean jacobianFresh;
    private double preparedFor;                         // the sub-step of the factorised matrices, 0 if there are none
    private boolean converged;
    private boolean rejected;
    private double lastTaken;                           // the sub-step before, 0 if there is none

    /** With the tolerances {@value #RELATIVE_TOLERANCE} and {@value #ABSOLUTE_TOLERANCE}. */
    public RadauIIASolver() {
        this(RELATIVE_TOLERANCE, ABSOLUTE_TOLERANCE);
    }

    /**
     * @param relativeTolerance error allowed for an entry of the state in one sub-step, relative to its size
     * @param absoluteTolerance error allowed besides, in the entry's unit
     * @throws IllegalArgumentException if one of them is negative or not finite, or both are 0
     */
    public RadauIIASolver(double relativeTolerance, double absoluteTolerance) {
        super(relativeTolerance, absoluteTolerance);
    }

    @Override
    protected void resize(int n) {
        newton = new RadauNewton(work, getTolerance(), n);
        z = new double[3][n];
        polynomial = new double[3][n];
        error = new double[n];
        right = new double[n];
        shifted = new double[n];
    }

    @Override
    protected void restart() {
        if (jacobian != null) {
            jacobian.forget();
        }
        jacobianKnown = false;
        preparedFor = 0;
        lastTaken = 0;
        rejected = false;
    }

    @Override
    protected double attempt(StepTransaction source, double[] state, double[] slope, double offset, double h,
            double[] newState) {
        converged = findStages(source, state, slope, offset, h);
        if (!converged) {
            return Double.POSITIVE_INFINITY;
        }
        for (int i = 0; i < state.length; i++) {
            newState[i] = state[i] + z[2][i];
        }
        source.setOffset(offset);
        double ratio = estimate(state, slope, h, newState);
        if (rejected && ratio > 1) {        // once more with the derivative at s + error: no stiff part is left
            for (int i = 0; i < state.length; i++) {
                right[i] = state[i] + error[i];
            }
            source.setState(right);
            source.setOffset(offset);
            source.getStateDerivative(shifted);
            ratio = StepTransaction.firstNonFinite(shifted) < 0 ? estimate(state, shifted, h, newState) : ratio;
        }
        return ratio;
    }

    /**
     * (mu - h J) error = h f - p'(0), divided by mu, in units of the tolerance: the derivative at the start against the
     * slope of the collocation polynomial there.
     */
    private double estimate(double[] state, double[] slope, double h, double[] newState) {
        for (int i = 0; i < state.length; i++) {
            right[i] = (h * slope[i] - RadauTableau.polynomial(1, z, i)) / RadauTableau.MU;
        }
        boolean solved = jacobian.solve(right, error, RadauNewton.LINEAR_TOLERANCE);
        return solved ? getTolerance().ratio(error, state, newState) : Double.POSITIVE_INFINITY;
    }

    /** With the Jacobian at hand, and once more with a new one if that was old and did not do. */
    private boolean findStages(StepTransaction source, double[] state, double[] slope, double offset, double h) {
        while (true) {
            if (!jacobianKnown || !jacobianFresh && !jacobian.keepsJacobian()) {
                jacobian = choice.of(source.getClient());
                source.setOffset(offset);
                jacobian.setJacobian(source, state, slope, h, ShiftedJacobian.Kind.EXACT);
                jacobianKnown = true;
                jacobianFresh = true;
                preparedFor = 0;
            }
            boolean prepared = preparedFor == h || prepare(h);
            preparedFor = prepared ? h : 0;
            guess(h);
            if (prepared && newton.solve(source, jacobian, state, offset, h, z)) {
                return true;
            }
            if (jacobianFresh) {
                return false;
            }
            jacobianKnown = false;
        }
    }

    private boolean prepare(double h) {
        return jacobian.prepare(h / RadauTableau.MU)
                && jacobian.prepareComplex(h * RadauTableau.MU_RE / RadauTableau.MU_SQUARE,
                        -h * RadauTableau.MU_IM / RadauTableau.MU_SQUARE);
    }

    /** The first guess: the last sub-step's polynomial, extrapolated; 0 in the first sub-step. */
    private void guess(double h) {
        double ratio = lastTaken == 0 ? 0 : h / lastTaken;
        for (int k = 0; k < 3; k++) {
            double u = 1 + RadauTableau.c(k) * ratio;
            double u2 = u * u - 1;
            double u3 = u * u * u - 1;
            for (int i = 0; i < error.length; i++) {
                z[k][i] = polynomial[0][i] * (u - 1) + polynomial[1][i] * u2 + polynomial[2][i] * u3;
            }
        }
    }

    /**
     * Chooses the next sub-step from this sub-step's error alone. The prediction from two errors (K. Gustafsson 1994,
     * ACM TOMS 20, 496), which other codes use, is left out: on a very stiff component the derivative at the start, and
     * with it the estimate, follows mostly the length of the sub-step <i>before</i>, e<sub>n</sub> ~
     * h<sub>n-1</sub><sup>3</sup>. There the prediction's h<sub>n</sub><sup>2</sup>/h<sub>n-1</sub>
     * (e<sub>n-1</sub>/e<sub>n</sub><sup>2</sup>)<sup>1/4</sup> swings ever more (its recursion in log h has roots of
     * modulus 1.36), while h<sub>n</sub> e<sub>n</sub><sup>-1/4</sup> settles (0.87). It cost up to a third more
     * evaluations on Prothero and Robinson's problem, and saved at most a tenth elsewhere.
     */
    @Override
    protected double nextSubStep(double h, double error) {
        if (!converged) {
            return h / 2;
        }
        int most = 2 * RadauNewton.MOST_ITERATIONS + 1;
        double safety = 0.9 * most / (most - 1 + newton.getIterations());
        double factor = error == 0 ? MOST_GROWTH : Math.sqrt(Math.sqrt(1 / error));
        factor = Math.max(MOST_SHRINKING, Math.min(MOST_GROWTH, safety * factor));
        rejected = error > 1;
        if (rejected) {
            return h * factor;
        }
        take();
        return jacobianKnown && factor >= 1 && factor < WORTH_FACTORISING ? h : h * factor;
    }

    /** The sub-step is taken: its polynomial serves the next one. */
    private void take() {
        for (int i = 0; i < this.error.length; i++) {
            for (int power = 0; power < 3; power++) {
                polynomial[power][i] = RadauTableau.polynomial(power + 1, z, i);
            }
        }
        jacobianKnown = !(newton.getIterations() > 2 && newton.getRate() > SLOW_RATE);
        jacobianFresh = false;
        lastTaken = preparedFor;
    }

    @Override
    protected int errorExponent() {
        return 4;
    }

    /** @return the work of all steps so far */
    public SolverWork getWork() {
        return work;
    }
}
