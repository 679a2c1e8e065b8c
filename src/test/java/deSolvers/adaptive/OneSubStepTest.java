package deSolvers.adaptive;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;

import deSolvers.DESolver;
import deSolvers.StepMatrixFormula;
import deSolvers.extrapolation.BulirschStoerSolver;
import deSolvers.problems.Oscillator;
import org.junit.jupiter.api.Test;

/** One sub-step of embedded pairs over all of deltaT, at a huge tolerance, against the stability function. */
class OneSubStepTest {
    private static final double EVERYTHING = 1e6;
    private static final double[] RK4 = {1, 1, 1.0 / 2, 1.0 / 6, 1.0 / 24};
    private static final double[] DORMAND_PRINCE = {1, 1, 1.0 / 2, 1.0 / 6, 1.0 / 24, 1.0 / 120, 1.0 / 600};

    @Test
    void aSubStepOfTheOscillatorIsTheClosedForm() {
        for (double h : new double[] {0.01, 0.1, 0.5, 1, -0.5}) {
            StepMatrixFormula.assertStep(new DormandPrinceSolver(1e-3, EVERYTHING), h,
                    StepMatrixFormula.polynomial(h, DORMAND_PRINCE));
            double[] half = StepMatrixFormula.polynomial(h / 2, RK4);
            StepMatrixFormula.assertStep(new StepDoublingSolver(1e-3, EVERYTHING), h,
                    StepMatrixFormula.product(half, half));
        }
    }

    private static long[] evaluationsOfTwoSteps(DESolver solver) {
        Oscillator problem = new Oscillator();
        solver.stepState(problem, 0.125);
        long first = problem.getEvaluations();
        solver.stepState(problem, 0.125);
        return new long[] {first, problem.getEvaluations() - first};
    }

    /** One for the derivative at the beginning and one for the first guess; then what the javadoc says. */
    @Test
    void evaluationsPerSubStepAreThoseOfTheJavadoc() {
        assertArrayEquals(new long[] {2 + 6, 6},
                evaluationsOfTwoSteps(new DormandPrinceSolver(1e-3, EVERYTHING)));
        assertArrayEquals(new long[] {2 + 10, 11},
                evaluationsOfTwoSteps(new StepDoublingSolver(1e-3, EVERYTHING)));
        assertArrayEquals(new long[] {2 + 8, 9},
                evaluationsOfTwoSteps(new BulirschStoerSolver(1e-3, EVERYTHING)));
    }
}
