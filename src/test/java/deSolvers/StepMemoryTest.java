package deSolvers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.problems.Oscillator;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A step goes on from the last one only where source, time, state and deltaT are its bits. */
class StepMemoryTest {
    private static final DEStateSource SOURCE = new Oscillator(1, 0, 1);
    private static final DEStateSource OTHER = new Oscillator(1, 0, 1);

    private static boolean continues(DEStateSource source, double time, double[] state, double deltaT) {
        StepMemory memory = new StepMemory();
        memory.keep(SOURCE, 3, 0.5);
        return memory.takeUp(source, time, state, deltaT, new double[] {1, 2});
    }

    @Test
    void allFourHaveToBeTheSame() {
        assertTrue(continues(SOURCE, 3, new double[] {1, 2}, 0.5));
        assertFalse(continues(OTHER, 3, new double[] {1, 2}, 0.5));
        assertFalse(continues(SOURCE, Math.nextUp(3.0), new double[] {1, 2}, 0.5));
        assertFalse(continues(SOURCE, 3, new double[] {1, Math.nextDown(2.0)}, 0.5));
        assertFalse(continues(SOURCE, 3, new double[] {1, 2, 0}, 0.5));
        assertFalse(continues(SOURCE, 3, new double[] {1, 2}, -0.5));
    }

    @Test
    void zerosHaveASign() {
        for (double zero : new double[] {0.0, -0.0}) {
            StepMemory memory = new StepMemory();
            memory.keep(SOURCE, 0.0, 0.5);
            assertEquals(1 / zero > 0, memory.takeUp(SOURCE, zero, new double[0], 0.5, new double[0]), "time " + zero);
            memory.keep(SOURCE, 0, 0.5);
            assertEquals(1 / zero > 0, memory.takeUp(SOURCE, 0, new double[] {zero, 1}, 0.5, new double[] {0, 1}), "state " + zero);
        }
    }

    /** Only the last step is continued, once, and none that was forgotten or has not been. */
    @Test
    void aStepIsContinuedOnce() {
        double[] state = {1, 2};
        StepMemory memory = new StepMemory();
        assertFalse(memory.takeUp(SOURCE, 3, state, 0.5, state), "none has been");
        memory.keep(SOURCE, 2.5, 0.5);
        memory.keep(SOURCE, 3, 0.5);
        assertTrue(memory.takeUp(SOURCE, 3, state, 0.5, state));
        assertFalse(memory.takeUp(SOURCE, 3, state, 0.5, state), "the step that continued it has not ended");
        memory.keep(SOURCE, 3, 0.5);
        assertFalse(memory.takeUp(OTHER, 3, state, 0.5, state));
        assertFalse(memory.takeUp(SOURCE, 3, state, 0.5, state), "another one has begun");
        memory.keep(SOURCE, 3, 0.5);
        memory.forget();
        assertFalse(memory.takeUp(SOURCE, 3, state, 0.5, state), "forgotten");
    }

    /** States are compared to the last entry, whatever their size. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 6, 100})
    void everyEntryCounts(int n) {
        StepMemory memory = new StepMemory();
        double[] left = new Random(n).doubles(n).toArray();
        for (int i = 0; i < n; i++) {
            double[] state = left.clone();
            memory.keep(SOURCE, 0, 1);
            assertTrue(memory.takeUp(SOURCE, 0, state, 1, left));
            state[i] = Math.nextUp(state[i]);
            memory.keep(SOURCE, 0, 1);
            assertFalse(memory.takeUp(SOURCE, 0, state, 1, left), "entry " + i);
        }
        left[n - 1] = Double.NaN;
        memory.keep(SOURCE, 0, 1);
        assertTrue(memory.takeUp(SOURCE, 0, left.clone(), 1, left), "bits are compared, not numbers");
    }
}
