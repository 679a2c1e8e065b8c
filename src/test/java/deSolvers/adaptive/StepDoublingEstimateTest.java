package deSolvers.adaptive;

import static deSolvers.problems.Bounds.assertAbove;
import static deSolvers.problems.Bounds.assertBelow;
import static deSolvers.problems.KnownSolutions.testEquation;
import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.StepTransaction;
import deSolvers.problems.ReferenceProblem;
import org.junit.jupiter.api.Test;

/** The error estimate of step doubling for s' = lambda s over the left half-plane of z = h lambda. */
class StepDoublingEstimateTest {
    private static final double FIRST_ZERO = -10.982425466293273;

    /** One sub-step of 1 s from s = 1: the estimate, the error and the result's modulus. */
    private record Trial(double estimate, double error, double modulus) {
    }

    private static Trial tryOne(double re, double im) {
        ReferenceProblem problem = testEquation(re, im);
        StepDoublingSolver solver = new StepDoublingSolver(0, 1);
        solver.resize(2);
        double[] newState = new double[2];
        try (StepTransaction step = new StepTransaction(solver.getClass()).begin(problem, 1)) {
            double[] exact = problem.exactState(1);
            double ratio = solver.attempt(step, new double[] {1, 0}, new double[] {re, im}, 0, 1, newState);
            return new Trial(ratio, Math.hypot(newState[0] - exact[0], newState[1] - exact[1]),
                    Math.hypot(newState[0], newState[1]));
        }
    }

    /** Where both results agree by chance, 436 and 402 times too large, the second estimate detects it. */
    @Test
    void theSecondEstimateDetectsChanceAgreement() {
        Trial real = tryOne(FIRST_ZERO, 0);
        Trial complex = tryOne(-2.50878727, 9.92979598);
        assertEquals(435.705, real.modulus(), 1e-3);
        assertEquals(-Math.pow(FIRST_ZERO, 5) / 15360, real.estimate(), 1e-9);
        assertEquals(401.83, complex.modulus(), 1e-2);
        assertAbove(6.9, complex.estimate());       // one entry's part of 7.3
    }

    /** Measured 76.7; with the first estimate alone the ratio is infinite. */
    @Test
    void theEstimateIsNeverFarBelowTheError() {
        double worst = 0;
        for (int angle = 0; angle <= 30; angle++) {
            double phi = Math.PI / 2 * (1 + angle / 30.0);
            for (double size = 2; size < 30; size += 0.02) {
                Trial trial = tryOne(size * Math.cos(phi), size * Math.sin(phi));
                worst = Math.max(worst, trial.error() / trial.estimate());
            }
        }
        assertBelow(100, worst);
    }

    /** For small steps the difference of the results decides; the second estimate is an eighth of it. */
    @Test
    void forSmallStepsTheFirstEstimateDecides() {
        for (double z : new double[] {-0.1, -0.01}) {
            double r = 1 + z + z * z / 2 + z * z * z / 6 + z * z * z * z / 24;
            double y = z / 2;
            double half = 1 + y + y * y / 2 + y * y * y / 6 + y * y * y * y / 24;
            assertEquals(Math.abs(half * half - r) / 15, tryOne(z, 0).estimate(), 1e-16);
        }
    }
}
