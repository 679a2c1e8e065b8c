package deSolvers.symplectic;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.DESolver;
import deSolvers.catalog.SolverCatalog;
import deSolvers.problems.ForcedOscillator;
import deSolvers.problems.SecondOrderProblem;
import deSolvers.problems.SpySource;
import deSolvers.problems.Steps;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What steps of leapfrogs remember. */
class LeapfrogTest {
    private static final double H = 0.5;

    /** One of the ten steps' first accelerations is new, and after a reset one more. */
    @ParameterizedTest
    @CsvSource({"verlet, 11, 13", "yoshida4, 31, 35"})
    void theLastAccelerationIsTheNextStepsFirst(String name, int afterTen, int afterReset) {
        ForcedOscillator problem = new ForcedOscillator();
        DESolver solver = SolverCatalog.create(name);
        Steps.make(10, solver, problem, 0.125);
        assertEquals(afterTen, problem.getEvaluations());
        solver.reset();
        solver.stepState(problem, 0.125);
        assertEquals(afterReset, problem.getEvaluations());
    }

    /** Any number of particles on a line, all with the acceleration -1. */
    private static final class Falling extends SecondOrderProblem {
        Falling(int particles) {
            super(1, new double[2 * particles]);
        }

        @Override
        protected void accelerate(double t, double[] s, double[] dSdt) {
            for (int x = 0; x < s.length; x += 2) {
                dSdt[x + 1] = -1;
            }
        }

        @Override
        public boolean accelerationDependsOnVelocity() {
            return false;
        }
    }

    /**
     * Its zeros are those of arrays that were just made, and source, time and deltaT are as the last step left them.
     */
    @Test
    void aSourceThatGrewAndIsAtRestBeginsAnew() {
        for (DESolver solver : new DESolver[] {new VelocityVerletSolver(), new Yoshida4Solver()}) {
            SpySource source = new SpySource(new Falling(1));
            solver.stepState(source, H);
            Falling grown = new Falling(2);
            grown.incTime(H);
            source.become(grown);
            solver.stepState(source, H);
            assertArrayEquals(new double[] {-H * H / 2, -H, -H * H / 2, -H}, grown.getState(), 1e-15);     // measured 0
        }
    }
}
