package particles.threads;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;

/** Each part of a piece of work is done once, whatever becomes of the others. */
class WorkersTest {
    /**
     * A state that makes one part fail makes the others fail too; the next step, of a state put right, has nothing of
     * it.
     */
    @Test
    void failuresOfAllThreadsAreOverWhenTheyWereThrown() {
        try (Workers workers = new Workers(3)) {
            assertThrows(ArithmeticException.class, () -> workers.run((part, parts) -> {
                throw new ArithmeticException("part " + part);
            }));
            int[] done = new int[3];
            workers.run((part, parts) -> done[part]++);
            assertArrayEquals(new int[] {1, 1, 1}, done);
        }
    }

    @Test
    void aFailureInAnyThreadReachesTheCallerAndTheWorkersGoOn() {
        try (Workers workers = new Workers(3)) {
            for (int bad = 0; bad < 3; bad++) {
                int failing = bad;
                int[] done = new int[3];
                assertThrows(ArithmeticException.class, () -> workers.run((part, parts) -> {
                    assertEquals(3, parts);
                    done[part]++;
                    if (part == failing) {
                        throw new ArithmeticException("part " + part);
                    }
                }));
                assertArrayEquals(new int[] {1, 1, 1}, done);
            }
        }
    }
}
