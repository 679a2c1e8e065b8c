package deSolvers.adaptive;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.DESolver;
import deSolvers.StepMatrixFormula;
import deSolvers.extrapolation.BulirschStoerSolver;
import deSolvers.problems.Oscillator;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;

/** One sub-step of embedded pairs over all of deltaT, at a huge tolerance, against the stability function. */
class OneSubStepTest {
    private static final double EVERYTHING = 1e6;
    private static final double[] RK4 = {1, 1, 1.0 / 2, 1.0 / 6, 1.0 / 24};
    private static final double[] DORMAND_PRINCE = {1, 1, 1.0 / 2, 1.0 / 6, 1.0 / 24, 1.0 / 120, 1.0 / 600};

    private static double at(double[] polynomial, double z) {
        double value = 0;
        for (int i = polynomial.length - 1; i >= 0; i--) {
            value = value * z + polynomial[i];
        }
        return value;
    }

    private static double[] square(double[] m) {
        return new double[] {m[0] * m[0] + m[1] * m[2], m[0] * m[1] + m[1] * m[3],
            m[2] * m[0] + m[3] * m[2], m[2] * m[1] + m[3] * m[3]};
    }

    private static void assertStep(DESolver solver, double h, double[] closed) {
        for (int column = 0; column < 2; column++) {
            Oscillator problem = new Oscillator(1, 1 - column, column);
            solver.reset();
            solver.stepState(problem, h);
            assertEquals(closed[column], problem.getState()[0], 1e-12, "x at h = " + h);
            assertEquals(closed[2 + column], problem.getState()[1], 1e-12, "v at h = " + h);
        }
    }

    @Test
    void aSubStepOfTheOscillatorIsTheClosedForm() {
        for (double h : new double[] {0.01, 0.1, 0.5, 1, -0.5}) {
            assertStep(new DormandPrinceSolver(1e-3, EVERYTHING), h,
                    StepMatrixFormula.polynomial(h, DORMAND_PRINCE));
            double[] twice = square(StepMatrixFormula.polynomial(h / 2, RK4));
            assertStep(new StepDoublingSolver(1e-3, EVERYTHING), h, twice);
        }
    }

    private static double limit(DoubleUnaryOperator amplification, double low, double high) {
        double stable = low;
        double unstable = high;
        assertTrue(amplification.applyAsDouble(stable) <= 1 && amplification.applyAsDouble(unstable) > 1);
        while (unstable - stable > 1e-9) {
            double mid = (stable + unstable) / 2;
            if (amplification.applyAsDouble(mid) <= 1) {
                stable = mid;
            } else {
                unstable = mid;
            }
        }
        return stable;
    }

    private static double modulus(double[] m) {
        return Math.sqrt(m[0] * m[0] + m[1] * m[1]);
    }

    /** The stability limits in javadoc and catalogue follow from these functions. */
    @Test
    void stabilityLimitsAreThoseOfTheJavadoc() {
        assertEquals(3.3066, limit(x -> Math.abs(at(DORMAND_PRINCE, -x)), 2, 5), 5e-5);
        assertEquals(0.9972, limit(y -> modulus(StepMatrixFormula.polynomial(y, DORMAND_PRINCE)), 0.5, 1.5), 5e-5);
        assertEquals(5.5706, limit(x -> Math.abs(at(RK4, -x / 2)), 2, 8), 5e-5);
        assertEquals(5.6569, limit(y -> modulus(StepMatrixFormula.polynomial(y / 2, RK4)), 2, 8), 5e-5);
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
