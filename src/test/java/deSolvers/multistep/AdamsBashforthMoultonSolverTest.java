package deSolvers.multistep;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.DESolver;
import deSolvers.StepMatrixFormula;
import deSolvers.problems.Decay;
import deSolvers.problems.Oscillator;
import deSolvers.problems.ReferenceProblem;
import deSolvers.problems.Steps;
import org.junit.jupiter.api.Test;

class AdamsBashforthMoultonSolverTest extends MultistepContract {
    @Override
    protected DESolver createSolver() {
        return new AdamsBashforthMoultonSolver();
    }

    @Override
    protected int order() {
        return 4;
    }

    /** Its higher error terms are larger than those of a one-step method: 4.065 between 100 and 200 steps. */
    @Override
    protected int[] orderSteps() {
        return new int[] {300, 600};
    }

    /** The first step after a restart is RK4. */
    @Override
    protected double[] oscillatorStep(double h) {
        return StepMatrixFormula.polynomial(h, 1, 1, 1.0 / 2, 1.0 / 6, 1.0 / 24);
    }

    @Override
    protected int startingSteps() {
        return 3;
    }

    @Override
    protected int evaluationsAStartingStep() {
        return 4;
    }

    @Override
    protected int evaluationsAStep() {
        return 2;
    }

    /** Both formulas integrate a polynomial of degree 4 exactly; one of degree 5 they do not. */
    @Test
    void polynomialsUpToDegreeFourAreExact() {
        for (int degree = 1; degree <= 5; degree++) {
            final int m = degree;
            ReferenceProblem problem = new ReferenceProblem(0) {
                @Override
                public double[] exactState(double t) {
                    return new double[] {StrictMath.pow(t, m)};
                }

                @Override
                protected void rates(double t, double[] s, double[] dSdt) {
                    dSdt[0] = m * StrictMath.pow(t, m - 1);
                }
            };
            DESolver solver = createSolver();
            Steps.make(64, solver, problem, 1.0 / 64);
            // The three steps of RK4 are Simpson's rule here, exact as well. Measured 0 up to degree 4, 1.8e-7 at 5.
            assertTrue(degree <= 4 ? problem.error() < 1e-15 : problem.error() > 1e-8, degree + ": " + problem.error());
        }
    }

    /** The growth per step once the start has died away: the largest root of the method's characteristic polynomial. */
    private static double growth(ReferenceProblem problem, double h, int from, int to) {
        DESolver solver = new AdamsBashforthMoultonSolver();
        double start = 0;
        for (int i = 1; i <= to; i++) {
            solver.stepState(problem, h);
            if (i == from) {
                start = norm(problem.getState());
            }
        }
        return StrictMath.pow(norm(problem.getState()) / start, 1.0 / (to - from));
    }

    private static double norm(double[] s) {
        double sum = 0;
        for (double x : s) {
            sum += x * x;
        }
        return Math.sqrt(sum);
    }

    @Test
    void growthOnTheImaginaryAxisMatchesTheory() {
        double at01 = growth(new Oscillator(), 0.1, 1000, 101_000) - 1;
        double at05 = growth(new Oscillator(), 0.5, 1000, 11_000) - 1;
        assertEquals(1.6e-7, at01, 0.05e-7);
        assertEquals(1.5e-3, at05, 0.05e-3);
    }

    @Test
    void theLimitOnTheRealAxisMatchesTheory() {
        ReferenceProblem decay = new Decay(1);
        double low = 1;
        double high = 2;
        while (high - low > 1e-4) {
            double mid = (low + high) / 2;
            decay.startAt(0);
            if (growth(decay, mid, 200, 1200) < 1) {
                low = mid;
            } else {
                high = mid;
            }
        }
        assertEquals(1.28, low, 0.01);
    }
}
