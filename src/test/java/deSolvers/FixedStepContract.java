package deSolvers;

import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.problems.Chain;
import deSolvers.problems.DragInWind;
import deSolvers.problems.ForcedOscillator;
import deSolvers.problems.GrowthInSeason;
import deSolvers.problems.Oscillator;
import deSolvers.problems.ReferenceProblem;
import org.junit.jupiter.api.Test;

/** Contract of solvers of fixed order: the measured order, and the closed form of a step on the oscillator. */
public abstract class FixedStepContract extends DESolverContract {
    private static final double DURATION = 2;

    /** @return the order p */
    protected abstract int order();

    /**
     * @param h a step
     * @return the matrix (row by row) by which one step from a new start multiplies (x, v) of x'' = -x; see
     *         {@link StepMatrixFormula}
     */
    protected abstract double[] oscillatorStep(double h);

    /** @return the step counts between which the order is measured: asymptotic, and above round-off */
    protected int[] orderSteps() {
        return switch (order()) {
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
        assertEquals(order(), slope, 0.05, problem.getClass().getSimpleName() + " for " + duration + " s");
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
            assertOrder(new GrowthInSeason(), DURATION);
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
            double[] closed = oscillatorStep(h);
            for (int column = 0; column < 2; column++) {
                Oscillator problem = new Oscillator(1, 1 - column, column);
                createSolver().stepState(problem, h);
                for (int row = 0; row < 2; row++) {
                    assertEquals(closed[2 * row + column], problem.getState()[row], 1e-12,
                            "row " + row + ", column " + column + " at h = " + h);
                }
            }
        }
    }
}
