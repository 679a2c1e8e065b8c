package deSolvers;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.problems.ArraySpySource;
import deSolvers.problems.DragInWind;
import deSolvers.problems.SecondOrderProblem;
import deSolvers.problems.SpySource;
import deSolvers.problems.Steps;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;

/** Contract of failing steps: the exception names the reason, and the source is put back where it was. */
public abstract class FailureContract extends ContractBasics {
    FailureContract(Supplier<DESolver> maker) {
        super(maker);
    }

    @Test
    void deltaTMustBeFinite() {
        for (double bad : NOT_FINITE) {
            SecondOrderProblem problem = windy(1);
            DESolver solver = createSolver();
            DESolverException e = assertThrows(DESolverException.class, () -> solver.stepState(problem, bad));
            assertSameBits(windy(1), problem, "deltaT " + bad);
            assertNames(e, "deltaT = " + bad);
            assertEquals(bad, e.getDeltaT());
        }
    }

    private void assertNames(DESolverException e, String... parts) {
        String solver = createSolver().getClass().getSimpleName();
        assertTrue(e.getMessage().startsWith(solver + " at t = " + START), e.getMessage());
        assertEquals(START, e.getTime());
        for (String part : parts) {
            assertTrue(e.getMessage().contains(part), "'" + part + "' in: " + e.getMessage());
        }
    }

    @Test
    void aNonFiniteClockIsNamed() {
        SecondOrderProblem problem = windy(1);
        problem.incTime(Double.NaN);
        Steps.assertFails(DESolverException.class, "clock", () -> createSolver().stepState(problem, STEP));
    }

    @Test
    void aClockThatCannotMoveStaysWhereItIs() {
        SecondOrderProblem problem = windy(1);
        problem.incTime(1.5e308 - START);
        Steps.assertFails(DESolverException.class, "the clock of the source cannot go that far",
                () -> createSolver().stepState(problem, 1e308));
        assertEquals(1.5e308, problem.getTime());
        assertArrayEquals(windy(1).getState(), problem.getState());
    }

    @Test
    void aNonFiniteStateOrDerivativeIsNamedAndPutBack() {
        for (double bad : NOT_FINITE) {
            for (int entry = 0; entry < 6; entry++) {
                SecondOrderProblem problem = windy(1);
                double[] state = problem.getState();
                state[entry] = bad;
                problem.setState(state);
                String ofState = "entry " + entry + " of the state is " + bad + " before the step";
                assertEntryIsNamed(problem, problem, STEP, entry, ofState);
                assertEntryIsNamed(problem, problem, 0, entry, ofState);
                SpySource source = new SpySource(windy(1));
                source.spoilDerivative(entry, bad, 0);
                assertEntryIsNamed(source, source.problem(), STEP, entry,
                        "entry " + entry + " of the derivative is " + bad);
            }
        }
    }

    private void assertEntryIsNamed(DEStateSource source, SecondOrderProblem problem, double deltaT, int entry,
            String message) {
        double[] state = problem.getState();
        DESolver solver = createSolver();
        DESolverException e = assertThrows(DESolverException.class, () -> solver.stepState(source, deltaT));
        assertNames(e, "deltaT = " + deltaT, message);
        assertEquals(entry, e.getEntry());
        assertArrayEquals(state, problem.getState());
        assertEquals(START, problem.getTime());
        assertStepsLikeNew(solver, windy(1), STEP, "after: " + message);
    }

    @Test
    void aDerivativeThatBecomesNonFiniteWithinTheStepIsNamed() {
        for (int entry = 0; entry < 6; entry++) {
            SpySource source = new SpySource(windy(1));
            source.spoilDerivative(entry, Double.NaN, START + STEP / 3);
            DESolver solver = createSolver();
            if (asksWithinTheStep(createSolver())) {
                DESolverException e = assertThrows(DESolverException.class, () -> solver.stepState(source, STEP));
                assertNames(e, "entry " + e.getEntry());    // the first one reached, not always the culprit
                assertSameBits(windy(1), source.problem(), "entry " + entry);
                assertStepsLikeNew(solver, windy(1), STEP, "after a bad derivative");
            }
        }
    }

    /** Euler and symplectic Euler evaluate the derivative only at the beginning of the step. */
    private static boolean asksWithinTheStep(DESolver solver) {
        SpySource source = new SpySource(windy(1));
        solver.stepState(source, STEP);
        return source.calls(SpySource.Call.DERIVATIVE) > 1;
    }

    @Test
    void anExceptionOfTheSourceRestoresStateAndTimeBitForBit() {
        for (SpySource.Call call : SpySource.Call.values()) {
            assertRestored(call, 100, call.compareTo(SpySource.Call.DIMENSION) < 0, () -> new SpySource(windy(1)));
            for (int blocks : new int[] {1, 11}) {
                assertRestored(call, 25, EnumSet.of(SpySource.Call.INC_TIME, SpySource.Call.DERIVATIVE,
                        SpySource.Call.SET_STATE).contains(call), () -> new ArraySpySource(windy(blocks)));
            }
        }
    }

    /** At every call of a short step, and at a sample of those of a long one. */
    private void assertRestored(SpySource.Call call, int every, boolean needed, Supplier<SpySource> source) {
        int k = 1;
        while (failsAt(source.get(), call, k)) {
            k += k < every ? 1 : k / 3;
        }
        assertTrue(k > 1 || !needed, call + " was never called");
    }

    /** The second step fails at the k-th call, then is made again; false if it has fewer calls. */
    private boolean failsAt(SpySource source, SpySource.Call call, int k) {
        int blocks = source.problem().getStateSize() / 6;
        SecondOrderProblem unbroken = windy(blocks);
        DESolver solver = createSolver();
        DESolver other = createSolver();
        solver.stepState(source, STEP);
        other.stepState(unbroken, STEP);
        assertSameBits(unbroken, source.problem(), "two solvers of one kind");
        source.failAt(call, k);
        try {
            solver.stepState(source, STEP);
            return false;
        } catch (SpySource.Failure expected) {
            assertSameBits(unbroken, source.problem(), "failure at " + call + " " + k);
        }
        solver.stepState(source, STEP);
        assertContinuedOrRestarted(source.problem(), other, unbroken, "the step after a failure at " + call + " " + k);
        return true;
    }

    /** A step after a failure has gone on as if uninterrupted, as the other solver does, or as a new solver begins. */
    private void assertContinuedOrRestarted(SecondOrderProblem stepped, DESolver other, SecondOrderProblem unbroken,
            String when) {
        SecondOrderProblem restarted = windy(unbroken.getStateSize() / 6);
        moveTo(restarted, unbroken);
        createSolver().stepState(restarted, STEP);
        other.stepState(unbroken, STEP);
        double[] end = stepped.getState();
        assertTrue(Arrays.equals(end, unbroken.getState()) || Arrays.equals(end, restarted.getState()), when);
    }

    @Test
    void timeIsRestoredEvenIfTheStateCannotBe() {
        DragInWind behind = new DragInWind(1, 1);
        behind.startAt(START);
        SpySource source = new SpySource(behind);
        source.failFrom(SpySource.Call.SET_STATE);
        DESolver solver = createSolver();
        assertThrows(SpySource.Failure.class, () -> solver.stepState(source, STEP));
        assertEquals(START, behind.getTime());
    }

    @Test
    void aFailureInOneSourceDoesNotAffectAnother() {
        for (int k = 1; k < 40; k++) {
            DESolver solver = createSolver();
            SecondOrderProblem a = windy(1);
            SecondOrderProblem unbroken = windy(1);
            DESolver other = createSolver();
            solver.stepState(a, STEP);
            other.stepState(unbroken, STEP);
            SpySource b = new SpySource(windy(1));
            b.failAt(SpySource.Call.DERIVATIVE, k);
            try {
                solver.stepState(b, STEP);
            } catch (SpySource.Failure expected) {
                assertSameBits(windy(1), b.problem(), "the source that failed");
            }
            solver.stepState(a, STEP);
            assertContinuedOrRestarted(a, other, unbroken, "a's step after b failed at evaluation " + k);
        }
    }

    /** A failed step may have resized the work arrays, so their remembered contents must not be used. */
    @Test
    void aFailedStepOfAnotherSizeDoesNotAffectTheNext() {
        DESolver solver = createSolver();
        DESolver other = createSolver();
        SecondOrderProblem problem = windy(1);
        SecondOrderProblem unbroken = windy(1);
        for (int i = 0; i < 6; i++) {
            solver.stepState(problem, STEP);
            other.stepState(unbroken, STEP);
        }
        assertThrows(DESolverException.class, () -> solver.stepState(windy(2), Double.NaN));
        solver.stepState(problem, STEP);
        assertContinuedOrRestarted(problem, other, unbroken, "after a failed step of two blocks");
    }
}
