package deSolvers.implicit;

import deSolvers.DEStateSource;
import deSolvers.FixedStepSolver;
import deSolvers.linear.ImplicitWork;

/**
 * The backward Euler method: one straight step along the derivative at its <i>end</i>,
 * s(t + h) = s(t) + h f(s(t + h), t + h).
 * <pre>
 *    1 | 1
 *   ---+---
 *      | 1
 * </pre>
 * The equation is solved by Newton's method to 1e-10 of each entry of the state, however small beside others, or to the
 * rounding of its terms (in practice to rounding), or an exception says that it was not; the
 * package's description tells the limits of that.
 * {@link #linearised()} makes a solver that takes the first of Newton's corrections and asks no more.
 *
 * <p><b>Order</b> 1.<br>
 * <b>Evaluations</b> a few a step for Newton's method, and n more for each Jacobian where the source does not know its
 * own ({@link deSolvers.JacobianStateSource}); no limit to the number is known beforehand.<br>
 * <b>Stability</b> R(z) = 1/(1 - z): L-stable, no limit on the step for anything that decays or oscillates. What is
 * stable is not accurate: an undamped spring loses amplitude by (1 + (h omega)<sup>2</sup>)<sup>-1/2</sup> a step.<br>
 * <b>When to use</b> stiff springs and strong damping where only the slow motion matters: cloth at frame rate. Not
 * where energy has to be kept, for which {@code implicit-midpoint} serves, nor where accuracy counts, for which
 * {@code radau} does.<br>
 * <b>Source</b> C. F. Curtiss, J. O. Hirschfelder (1952), Proc. Nat. Acad. Sci. 38, 235; D. Baraff, A. Witkin,
 * <i>Large Steps in Cloth Simulation</i>, SIGGRAPH 1998, for the linearised step.
 */
public final class BackwardEulerSolver extends FixedStepSolver {
    private final ImplicitStage stage = new ImplicitStage();
    private final ImplicitStage.Way way;

    /** A solver that iterates until Newton's method has converged. */
    public BackwardEulerSolver() {
        this(ImplicitStage.Way.STRAIGHT_ON);
    }

    private BackwardEulerSolver(ImplicitStage.Way way) {
        this.way = way;
    }

    /**
     * A solver that linearises f at the beginning of the step and solves the linear equation once, to 1e-8 relative:
     * the linearly implicit Euler method. As stable on linear systems and of the same order, cheaper, and without
     * Newton's promise to have solved the nonlinear equation.
     *
     * @return a new solver
     */
    public static BackwardEulerSolver linearised() {
        return new BackwardEulerSolver(ImplicitStage.Way.LINEARISED);
    }

    @Override
    protected void step(DEStateSource source, double[] s, double deltaT) {
        source.incTime(deltaT);
        stage.solve(getTransaction(), copy(s), deltaT, way, s);         // s = s(t) + h f(s, t + h)
    }

    /** @return what was done in all steps so far */
    public ImplicitWork getWork() {
        return stage.getWork();
    }
}
