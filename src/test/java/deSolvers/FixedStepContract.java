package deSolvers;

import static deSolvers.problems.KnownSolutions.growthInSeason;
import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.problems.Chain;
import deSolvers.problems.DragInWind;
import deSolvers.problems.ForcedOscillator;
import deSolvers.problems.ReferenceProblem;
import java.util.function.DoubleFunction;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;

/** Contract of solvers of fixed order: the measured order, and the closed form of a step on the oscillator. */
public abstract class FixedStepContract extends DESolverContract {
    private static final double DURATION = 2;

    private final int order;
    private final DoubleFunction<double[]> oscillatorStep;

    /**
     * @param maker          makes a new solver
     * @param order          p
     * @param oscillatorStep the matrix (row by row) by which one step of h from a new start multiplies (x, v) of
     *                       x'' = -x; see {@link StepMatrixFormula}
     */
    protected FixedStepContract(Supplier<DESolver> maker, int order, DoubleFunction<double[]> oscillatorStep) {
        super(maker);
        this.order = order;
        this.oscillatorStep = oscillatorStep;
    }

    /** @return the step counts between which the order is measured: asymptotic, and above round-off */
    protected int[] orderSteps() {
        return switch (order) {
            case 1 -> new int[] {2048, 8192};
            case 2 -> new int[] {512, 2048};
            default -> new int[] {100, 200};
        };
    }

    /** The slope between two step counts; measured from p - 0.024 (rk4, backwards) to p + 0.032 (adams). */
    private void assertOrder(ReferenceProblem problem, double duration) {
        int[] steps = orderSteps();
        double slope = StrictMath.log(errorAfter(problem, duration, steps[0]) / errorAfter(problem, duration, steps[1]))
                / StrictMath.log((double) steps[1] / steps[0]);
        assertEquals(order, slope, 0.05, problem.getClass().getSimpleName() + " for " + duration + " s");
    }

    private double errorAfter(ReferenceProblem problem, double duration, int steps) {
        DESolver solver = createSolver();
        problem.startAt(duration < 0 ? -duration : 0);
        for (int i = 0; i < steps; i++) {
            solver.stepState(problem, duration / steps);
        }
        return problem.error();
    }

    @Test
    void theOrderHoldsWhereTheDerivativeDependsOnTime() {
        if (!needsSecondOrder()) {
            assertOrder(growthInSeason(), DURATION);
        }
        assertOrder(new ForcedOscillator(), DURATION);
    }

    @Test
    void theOrderHoldsWithDragAndWind() {
        assertOrder(new DragInWind(2, 2), DURATION);
    }

    @Test
    void theOrderHoldsWithSpringDamping() {
        assertOrder(new Chain(3, 2, 0.3), DURATION);
    }

    @Test
    void theOrderHoldsBackwardsInTime() {
        assertOrder(new DragInWind(2, 2), -DURATION);
    }

    @Test
    void oneStepOnTheOscillatorIsTheClosedForm() {
        for (double h : new double[] {0.01, 0.1, 0.5, 1, -0.5}) {
            StepMatrixFormula.assertStep(createSolver(), h, oscillatorStep.apply(h));
        }
    }
}
