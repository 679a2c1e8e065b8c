package deSolvers;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.problems.Chain;
import deSolvers.problems.Oscillator;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A step goes on from the last one only where source, time, state and deltaT are its bits. */
class StepMemoryTest {
    private static final DEStateSource SOURCE = new Oscillator(1, 0, 1);
    private static final DEStateSource OTHER = new Oscillator(1, 0, 1);

    @Test
    void allFourHaveToBeTheSame() {
        StepMemory memory = new StepMemory();
        assertFalse(memory.holds(SOURCE, 0, new double[0], 0), "of nothing");
        double[] state = {1, 2};
        memory.keep(SOURCE, 3, state, 0.5);
        assertTrue(memory.holds(SOURCE, 3, new double[] {1, 2}, 0.5));
        assertFalse(memory.holds(OTHER, 3, new double[] {1, 2}, 0.5));
        assertFalse(memory.holds(SOURCE, Math.nextUp(3.0), new double[] {1, 2}, 0.5));
        assertFalse(memory.holds(SOURCE, 3, new double[] {1, Math.nextDown(2.0)}, 0.5));
        assertFalse(memory.holds(SOURCE, 3, new double[] {1, 2, 0}, 0.5));
        assertFalse(memory.holds(SOURCE, 3, new double[] {1, 2}, -0.5));
        memory.keep(SOURCE, 0.0, new double[] {0, 1, 2}, 0.5);
        assertTrue(memory.holds(SOURCE, 0.0, new double[] {0, 1, 2}, 0.5));
        assertFalse(memory.holds(SOURCE, -0.0, new double[] {0, 1, 2}, 0.5), "a zero has a sign");
        assertFalse(memory.holds(SOURCE, 0.0, new double[] {-0.0, 1, 2}, 0.5));
        memory.forget();
        assertFalse(memory.holds(SOURCE, 0.0, new double[] {0, 1, 2}, 0.5));
    }

    /** States are compared to the last entry, whatever their size; the array itself is kept. */
    @ParameterizedTest
    @ValueSource(ints = {2, 14, 16, 18, 100})
    void everyEntryCounts(int n) {
        DEStateSource source = new Chain(n / 2, 1);
        StepMemory memory = new StepMemory();
        double[] first = new Random(n).doubles(n).toArray();
        double[] state = new Random(n + 1).doubles(n).toArray();
        memory.keep(source, 0, first, 1);
        memory.keep(source, 0, state, 1);
        assertFalse(memory.holds(source, 0, first, 1), "the last one is kept");
        for (int i = 0; i < n; i++) {
            double[] other = state.clone();
            assertTrue(memory.holds(source, 0, other, 1));
            other[i] = Math.nextUp(other[i]);
            assertFalse(memory.holds(source, 0, other, 1), "entry " + i);
        }
        double[] kept = state.clone();
        state[n - 1] = 7;
        assertFalse(memory.holds(source, 0, kept, 1), "no copy is made");
        kept[0] = Double.NaN;
        memory.keep(source, 0, kept, 1);
        assertTrue(memory.holds(source, 0, kept.clone(), 1), "bits are compared, not numbers");
    }
}
