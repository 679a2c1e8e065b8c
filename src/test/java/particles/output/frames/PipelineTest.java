package particles.output.frames;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class PipelineTest {
    private static final int COUNT = 200;

    /** Earlier tasks take longer, so that with several threads later ones are ready first. */
    private static void work(int k) {
        double sum = 0;
        for (int i = 0; i < 2000 * (7 - k % 7); i++) {
            sum += Math.sqrt(i);
        }
        assertTrue(sum > 0);
    }

    @Test
    void restsRunInOrderWithAtMostOneToolPerThread() {
        for (int threads : new int[] {1, 2, 5}) {
            List<Integer> done = new ArrayList<>();
            AtomicInteger tools = new AtomicInteger();
            try (Pipeline<Integer> pipeline = new Pipeline<>(threads, tools::incrementAndGet)) {
                for (int k = 0; k < COUNT; k++) {
                    int number = k;
                    pipeline.add(tool -> {
                        work(number);
                        return () -> done.add(number);
                    });
                }
            }
            assertEquals(IntStream.range(0, COUNT).boxed().toList(), done);
            assertTrue(tools.get() <= threads, tools + " tools for " + threads + " threads");
        }
    }

    /** With the first task held back, the caller can add no more than one a thread and two that wait. */
    @Test
    void onlyAFewTasksAreInProgressAtATime() throws InterruptedException {
        int threads = 3;
        CountDownLatch held = new CountDownLatch(1);
        AtomicInteger added = new AtomicInteger();
        CountDownLatch full = new CountDownLatch(threads + 2);
        Thread caller = new Thread(() -> {
            try (Pipeline<Object> pipeline = new Pipeline<>(threads, Object::new)) {
                for (int k = 0; k < COUNT; k++) {
                    boolean first = k == 0;
                    pipeline.add(tool -> () -> {
                        if (first) {
                            assertDoesNotThrow(() -> held.await());
                        }
                    });
                    added.incrementAndGet();
                    full.countDown();
                }
            }
        });
        caller.start();
        full.await();
        while (caller.getState() != Thread.State.WAITING) {
            Thread.onSpinWait();
        }
        assertEquals(threads + 2, added.get());
        held.countDown();
        caller.join();
        assertEquals(COUNT, added.get());
    }

    /** The failures of tasks 50 and 51, in either part; the first in order counts, and nothing after it is run. */
    @Test
    void theEarliestFailureIsThrownOnceAndEndsTheWork() {
        for (int threads : new int[] {1, 2, 5}) {
            for (boolean inRest : new boolean[] {false, true}) {
                List<Integer> done = new ArrayList<>();
                IllegalStateException[] failures = {new IllegalStateException("50"), new IllegalStateException("51")};
                Pipeline<Object> pipeline = new Pipeline<>(threads, Object::new);
                IllegalStateException thrown = assertThrows(IllegalStateException.class, () -> {
                    for (int k = 0; k < COUNT; k++) {
                        int number = k;
                        pipeline.add(tool -> {
                            work(number);
                            if (!inRest && (number == 50 || number == 51)) {
                                throw failures[number - 50];
                            }
                            return () -> {
                                if (number == 50 || number == 51) {
                                    throw failures[number - 50];
                                }
                                done.add(number);
                            };
                        });
                    }
                    pipeline.close();
                });
                assertSame(failures[0], thrown);
                assertDoesNotThrow(pipeline::close);
                assertEquals(IntStream.range(0, 50).boxed().toList(), done);
            }
        }
    }

    /** Task 3 fails, as on a full disk; only the few tasks already in progress then may begin. */
    @Test
    void noTaskBeginsAfterAFailure() {
        for (int threads : new int[] {1, 2, 5}) {
            IllegalStateException failure = new IllegalStateException("3");
            AtomicInteger begun = new AtomicInteger();
            AtomicInteger added = new AtomicInteger();
            Pipeline<Object> pipeline = new Pipeline<>(threads, Object::new);
            Runnable addAll = () -> {
                for (int k = 0; k < COUNT; k++) {
                    int number = k;
                    pipeline.add(tool -> {
                        begun.incrementAndGet();
                        work(number);
                        return () -> {
                            if (number == 3) {
                                throw failure;
                            }
                        };
                    });
                    added.incrementAndGet();
                }
            };
            assertSame(failure, assertThrows(IllegalStateException.class, addAll::run));
            int before = added.get();
            assertTrue(begun.get() <= 3 + threads + 2, begun + " tasks begun by " + threads + " threads");
            assertTrue(before <= 3 + threads + 3, before + " tasks added");
            assertSame(failure, assertThrows(IllegalStateException.class, addAll::run));
            assertEquals(before, added.get());
            assertDoesNotThrow(pipeline::close);
        }
    }

    /** A tool that cannot be made, as when memory is short, ends the work like any failure. */
    @Test
    void aToolThatCannotBeMadeIsAFailure() {
        OutOfMemoryError failure = new OutOfMemoryError("test");
        Pipeline<Object> pipeline = new Pipeline<>(2, () -> {
            throw failure;
        });
        pipeline.add(tool -> () -> { });
        assertSame(failure, assertThrows(OutOfMemoryError.class, pipeline::close));
    }
}
