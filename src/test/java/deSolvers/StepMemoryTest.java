package deSolvers;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.problems.Oscillator;
import org.junit.jupiter.api.Test;

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
        state[0] = 7;                                   // the caller's array is the caller's
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
}
