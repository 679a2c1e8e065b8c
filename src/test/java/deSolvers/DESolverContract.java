package deSolvers;

import static deSolvers.problems.Bounds.assertBelow;
import static deSolvers.problems.KnownSolutions.growthInSeason;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.problems.DragInWind;
import deSolvers.problems.Oscillator;
import deSolvers.problems.ReferenceProblem;
import deSolvers.problems.SecondOrderProblem;
import deSolvers.problems.SpySource;
import deSolvers.problems.Steps;
import java.util.Arrays;
import java.util.Random;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;

/**
 * Contract tests of {@link DESolver}, clause by clause, for any solver. A solver's test extends this class, or {@link
 * FixedStepContract}, which adds the measured order.
 */
public abstract class DESolverContract extends FailureContract {
    /** @param maker makes a new solver */
    protected DESolverContract(Supplier<DESolver> maker) {
        super(maker);
    }

    /** @return whether the solver takes only second-order sources */
    protected boolean needsSecondOrder() {
        return false;
    }

    @Test
    void theClockEndsExactlyAtTimePlusDeltaT() {
        DESolver solver = createSolver();
        SecondOrderProblem problem = windy(1);
        problem.startAt(0);
        for (int i = 1; i <= 1000; i++) {
            solver.stepState(problem, 1.0 / 64);
            assertEquals(i / 64.0, problem.getTime());                      // dyadic: exact for ever
        }
        Random random = new Random(715);
        for (int i = 0; i < 200; i++) {
            problem.startAt(random.nextDouble() * StrictMath.pow(10, random.nextInt(7)));
            double deltaT = (random.nextDouble() - 0.3) / 16;
            double end = problem.getTime() + deltaT;                        // any: the nearest double
            solver.stepState(problem, deltaT);
            assertEquals(end, problem.getTime());
        }
    }

    @Test
    void aStepMovesTheStateAlongTheSolution() {
        DESolver solver = createSolver();
        SecondOrderProblem problem = windy(2);
        double[] before = problem.getState();
        solver.stepState(problem, STEP);
        assertFalse(Arrays.equals(before, problem.getState()), "the state moved");
        // Even Euler's step errs by no more than h^2/2 |s''| <= 0.005 * 4 here (measured 0.0132 for euler).
        assertBelow(0.02, problem.error());
    }

    @Test
    void aNegativeStepGoesBack() {
        SecondOrderProblem problem = windy(1);
        DESolver solver = createSolver();
        Steps.make(64, solver, problem, -1.0 / 256);
        assertEquals(START - 0.25, problem.getTime());
        // First order: 0.25 * h/2 * |s''| <= 0.25/512 * 4 = 0.002 (measured 9.1e-4 for symplectic-euler).
        assertBelow(0.002, problem.error());
    }

    @Test
    void deltaTOfZeroChangesNothing() {
        for (double zero : new double[] {0.0, -0.0}) {
            SecondOrderProblem problem = windy(2);
            SecondOrderProblem untouched = windy(2);
            DESolver solver = createSolver();
            solver.stepState(problem, zero);
            assertSameBits(untouched, problem, "deltaT " + zero);
            assertStepsLikeNew(solver, problem, STEP, "after deltaT " + zero);
        }
    }

    @Test
    void aTinyStepMakesATinyChange() {
        Oscillator problem = new Oscillator(1, 0, 1);
        createSolver().stepState(problem, 1e-300);
        assertEquals(1e-300, problem.getState()[0], 1e-312);                   // x = sin(1e-300); 100 ulps
        assertEquals(1, problem.getState()[1]);
        assertEquals(1e-300, problem.getTime());
        SecondOrderProblem later = windy(1);
        SecondOrderProblem untouched = windy(1);
        createSolver().stepState(later, 1e-300);                            // below the clock's resolution
        assertEquals(START, later.getTime());
        assertArrayEquals(untouched.getState(), later.getState(), 1e-15);
    }

    @Test
    void aStateOfSizeZeroStillMovesTheClock() {
        SecondOrderProblem nothing = new DragInWind(3, 0);
        DESolver solver = createSolver();
        solver.stepState(nothing, 0.25);
        solver.stepState(nothing, -0.125);
        assertEquals(0.125, nothing.getTime());
    }
    @Test
    void oneSolverStepsSeveralSourcesInTurn() {
        DESolver shared = createSolver();
        int[] sizes = {1, 1, 4, 0, 2, 1};
        SecondOrderProblem[] problems = new SecondOrderProblem[sizes.length];
        for (int i = 0; i < sizes.length; i++) {
            problems[i] = windy(sizes[i]);
            problems[i].startAt(START + i);
        }
        for (int round = 0; round < 6; round++) {
            for (int i = 0; i < sizes.length; i++) {
                assertStepsLikeNew(shared, problems[i], STEP, "source " + i + " in round " + round);
            }
        }
    }

    @Test
    void anythingButTheVeryNextStepRestarts() {
        assertRestarts("another state", STEP, problem -> {
            double[] state = problem.getState();
            state[4] = Math.nextUp(state[4]);
            problem.setState(state);
            return problem;
        });
        assertRestarts("another time", STEP, problem -> {
            problem.incTime(1.5 - problem.getTime());
            return problem;
        });
        assertRestarts("another deltaT", Math.nextUp(STEP), problem -> problem);
        assertRestarts("the way back", -STEP, problem -> problem);
        assertRestarts("another source at the same place", STEP, problem -> {
            SecondOrderProblem twin = windy(1);
            moveTo(twin, problem);
            return twin;
        });
    }

    private void assertRestarts(String when, double deltaT, UnaryOperator<SecondOrderProblem> change) {
        SecondOrderProblem problem = windy(1);
        DESolver solver = createSolver();
        Steps.make(5, solver, problem, STEP);
        assertStepsLikeNew(solver, change.apply(problem), deltaT, when);
    }

    @Test
    void resetClearsTheMemoryAndNoArrayIsShared() {
        SpySource source = new SpySource(windy(1));
        DESolver solver = createSolver();
        Steps.make(5, solver, source, STEP);
        SecondOrderProblem place = windy(1);
        moveTo(place, source.problem());
        solver.reset();
        source.spoilArrays();
        assertSameBits(place, source.problem(), "the solver's arrays are not the source's");
        createSolver().stepState(place, STEP);
        solver.stepState(source, STEP);
        assertSameBits(place, source.problem(), "after reset() nothing of old remains");
    }

    /** As {@link #windy}, without StrictMath.sin, which allocates from JDK 21 on. */
    private static final class DragInRisingWind extends SecondOrderProblem {
        DragInRisingWind() {
            super(3, new double[24]);
        }

        @Override
        protected void accelerate(double t, double[] s, double[] dSdt) {
            for (int v = 3; v < s.length; v += (v + 1) % 3 == 0 ? 4 : 1) {
                dSdt[v] = -s[v - 3] - 0.4 * (s[v] - t);
            }
        }
    }

    @Test
    void aStepAllocatesNothing() {
        SecondOrderProblem problem = new DragInRisingWind();
        DESolver solver = createSolver();
        Steps.make(300, solver, problem, 1.0 / 64);
        long bytes = Steps.allocatedIn(1000, solver, problem, 1.0 / 64);
        // Measured 0; one boxed number a step would be 16,000. The bound allows for the measurement itself.
        assertBelow(1000, bytes);
    }

    @Test
    void sourcesOfFirstOrderAreSteppedOrRefusedWithBothTypesNamed() {
        ReferenceProblem firstOrder = growthInSeason();
        if (!needsSecondOrder()) {
            createSolver().stepState(firstOrder, 1.0 / 16);
            assertBelow(0.003, firstOrder.error());  // measured 0.00195 for euler
            return;
        }
        IllegalArgumentException e = Steps.assertFails(IllegalArgumentException.class,
                SecondOrderStateSource.class.getName(),
                () -> createSolver().stepState(firstOrder, STEP));
        assertTrue(e.getMessage().contains(DEStateSource.class.getName()), e.getMessage());
        assertEquals(0, firstOrder.getTime());
    }
}
