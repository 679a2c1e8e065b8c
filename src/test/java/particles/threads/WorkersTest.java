package particles.threads;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;

/** Each part of a task runs once, even if others fail. */
class WorkersTest {
    /** All parts fail on a bad state; after that is repaired, the next task does not throw again. */
    @Test
    void aThrownFailureIsNotThrownAgain() {
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
