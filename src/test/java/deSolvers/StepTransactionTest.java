package deSolvers;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;

import deSolvers.problems.Steps;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests {@link StepTransaction} call by call; {@link DESolverContract} tests every solver. */
class StepTransactionTest {
    private static final double START = 0.75;
    private static final double DELTA_T = 0.25;

    /** A source with ds/dt = -1 in every entry. */
    private static class Falling implements DEStateSource {
        double[] state;
        double time = START;
        double slope = -1;

        Falling(int n) {
            state = new double[n];
        }

        @Override
        public int getStateSize() {
            return state.length;
        }

        @Override
        public void getState(double[] copy) {
            System.arraycopy(state, 0, copy, 0, state.length);
        }

        @Override
        public void setState(double[] values) {
            System.arraycopy(values, 0, state, 0, state.length);
        }

        @Override
        public void getStateDerivative(double[] dSdt) {
            for (int i = 0; i < dSdt.length; i++) {
                dSdt[i] = slope + 0 * state[i];
            }
        }

        @Override
        public double getTime() {
            return time;
        }

        @Override
        public void incTime(double deltaT) {
            time += deltaT;
        }
    }

    /** The same as an {@link ArrayStateSource}. */
    private static final class FallingArrays extends Falling implements ArrayStateSource {
        FallingArrays(int n) {
            super(n);
        }

        @Override
        public double[] getStateArray() {
            return state;
        }

        @Override
        public void getStateDerivative(double[] given, double[] dSdt) {
            Arrays.fill(dSdt, slope);
        }
    }

    private static double[] filled(int n, double value) {
        double[] array = new double[n];
        Arrays.fill(array, value);
        return array;
    }

    @Test
    void aTransactionPassesCallsToItsSource() {
        Falling client = new Falling(2);
        StepTransaction guard = new StepTransaction(EulerSolver.class);
        try (StepTransaction step = guard.begin(client, DELTA_T)) {
            assertSame(client, step.getClient());
            assertEquals(START, step.getStartTime());
            assertEquals(DELTA_T, step.getDeltaT());
            assertEquals(2, step.getStateSize());
            step.setState(new double[] {3, 4});
            assertArrayEquals(new double[] {3, 4}, client.state);
            assertArrayEquals(new double[2], step.getStartState());
            double[] copy = new double[2];
            step.getState(copy);
            assertArrayEquals(client.state, copy);
            step.incTime(DELTA_T / 2);
            assertEquals(START + DELTA_T / 2, step.getTime());
            step.setOffset(-DELTA_T);
            assertEquals(START - DELTA_T, client.time);
            assertEquals("a step of EulerSolver from t = 0.75 with [0.0, 0.0]", step.toString());
        }
        assertArrayEquals(new double[2], client.state, "nothing was finished");
        assertEquals(START, client.time);
    }

    @Test
    void derivativesAreEvaluatedAtTheGivenState() {
        Falling client = new Falling(1);
        double[] dSdt = new double[1];
        try (StepTransaction step = new StepTransaction(EulerSolver.class).begin(client, DELTA_T)) {
            step.getStateDerivative(step.getStartState(), dSdt);
            step.getStateDerivative(new double[] {5}, dSdt);
            assertEquals(5, client.state[0]);
            step.getStateDerivative(step.getStartState(), dSdt);
            assertEquals(0, client.state[0]);
            step.setState(new double[] {6});
            step.getStateDerivative(step.getStartState(), dSdt);
            assertEquals(0, client.state[0]);
        }
    }

    /** The client gets a copy of the new state, and keeps its own in a step of 0 s. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void theNewStateIsCopiedIntoTheClient(boolean arrays) {
        Falling client = arrays ? new FallingArrays(3) : new Falling(3);
        double[] next = filled(3, -1);
        try (StepTransaction step = new StepTransaction(EulerSolver.class).begin(client, DELTA_T)) {
            step.finish(next);
        }
        assertNotSame(next, client.state);
        assertArrayEquals(filled(3, -1), client.state);
        assertEquals(START + DELTA_T, client.time);

        Falling still = arrays ? new FallingArrays(3) : new Falling(3);
        try (StepTransaction step = new StepTransaction(EulerSolver.class).begin(still, 0)) {
            step.finish(next);
        }
        assertArrayEquals(new double[3], still.state);
    }

    /** If a solver changes the source's own array, a copy keeps the state at the step's beginning. */
    @Test
    void anArrayIsCopiedBeforeASolverChangesIt() {
        FallingArrays client = new FallingArrays(64);
        StepTransaction guard = new StepTransaction(EulerSolver.class);
        try (StepTransaction step = guard.begin(client, DELTA_T)) {
            assertSame(client.state, step.getStartState());
            step.setState(filled(64, 9));
            assertNotSame(client.state, step.getStartState());
            assertArrayEquals(new double[64], step.getStartState());
        }
        assertArrayEquals(new double[64], client.state);
    }

    /**
     * The first cause is named: a non-finite initial state, then a non-finite derivative, then the size of the step.
     */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void theFirstCauseIsNamed(boolean arrays) {
        Falling client = arrays ? new FallingArrays(64) : new Falling(64);
        double[] beyond = filled(64, 0);
        beyond[40] = Double.POSITIVE_INFINITY;
        assertMessage(client, beyond, "entry 40 of the state became Infinity within the step");
        client.slope = Double.NaN;
        assertMessage(client, beyond, "entry 0 of the derivative is NaN at t = 0.75");
        client.state[17] = Double.NaN;
        assertMessage(client, beyond, "entry 17 of the state is NaN before the step");
        client.slope = -1;
        assertMessage(client, beyond, "entry 17 of the state is NaN before the step");
    }

    private static void assertMessage(Falling client, double[] end, String part) {
        double[] before = client.state.clone();
        Steps.assertFails(DESolverException.class, part, () -> {
            try (StepTransaction step = new StepTransaction(EulerSolver.class).begin(client, DELTA_T)) {
                step.incTime(DELTA_T);
                step.finish(end);
            }
        });
        assertEquals(START, client.time);
        assertArrayEquals(before, client.state);
    }

    /** A derivative that a solver checks itself. */
    @Test
    void aNonFiniteStateIsNamedInsteadOfItsDerivative() {
        Falling client = new Falling(3);
        try (StepTransaction step = new StepTransaction(EulerSolver.class).begin(client, DELTA_T)) {
            step.requireFinite(new double[3]);
            DESolverException e = Steps.assertFails(DESolverException.class, "entry 1 of the derivative is NaN",
                    () -> step.requireFinite(new double[] {0, Double.NaN, 0}));
            assertEquals(1, e.getEntry());
        }
        client.state[2] = Double.NEGATIVE_INFINITY;
        try (StepTransaction step = new StepTransaction(EulerSolver.class).begin(client, DELTA_T)) {
            DESolverException e = Steps.assertFails(DESolverException.class,
                    "entry 2 of the state is -Infinity before the step",
                    () -> step.requireFinite(new double[] {0, Double.NaN, 0}));
            assertEquals(2, e.getEntry());
        }
    }
}
