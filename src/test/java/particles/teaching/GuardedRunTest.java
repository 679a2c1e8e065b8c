package particles.teaching;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;

/** A class that does not come back ends its check with a clear line, and with the place where it was. */
class GuardedRunTest {

    /** What students write; the name lets the machinery be told from them. */
    private static final class PlantedClasses {
        static long endlessLoop(AtomicLong steps) {
            while (!Thread.currentThread().isInterrupted()) {       // the test's only concession: it ends when it is told to
                steps.incrementAndGet();
            }
            return steps.get();
        }

        static int callsItself(int n) {
            return callsItself(n + 1) + 1;
        }

        static List<double[]> asksForAllMemory() {
            List<double[]> all = new ArrayList<>();
            while (true) {
                all.add(new double[Integer.MAX_VALUE - 8]);
            }
        }

        static int dividesByZero() {
            return 1 / new ArrayList<String>().size();
        }
    }

    private static String failure(Callable<?> what) {
        GuardedRun.Outcome<?> outcome = new GuardedRun(0.3).run(what);
        assertTrue(outcome.value().isEmpty());
        return outcome.failure().orElseThrow().toString();
    }

    private static void assertStarts(String expected, String found) {
        assertTrue(found.startsWith(expected), found);
        assertTrue(found.contains("GuardedRunTest.java"), found);
    }

    @Test
    void whatComesBackIsHandedOn() {
        assertEquals("done", new GuardedRun(0.3).run(() -> "done").value().orElseThrow());
    }

    @Test
    void anEndlessLoopIsStopped() {
        AtomicLong steps = new AtomicLong();
        assertStarts("failure: it did not come back within 3/10 s: an endless loop, in PlantedClasses.endlessLoop, line ",
                failure(() -> PlantedClasses.endlessLoop(steps)));
        assertTrue(steps.get() > 0);
    }

    @Test
    void waitingForEverIsStopped() {
        CountDownLatch never = new CountDownLatch(1);
        String found = failure(() -> {
            never.await();
            return 1;
        });
        assertTrue(found.startsWith("failure: it did not come back within 3/10 s: it waits for something that never comes"),
                found);
    }

    @Test
    void aStackOverflowIsNamed() {
        assertStarts("failure: the stack overflows: a method calls itself without end, in PlantedClasses.callsItself, line ",
                failure(() -> PlantedClasses.callsItself(0)));
    }

    @Test
    void aHugeAllocationIsNamed() {
        assertStarts("failure: it asks for more memory than the ", failure(PlantedClasses::asksForAllMemory));
    }

    @Test
    void anExceptionIsNamedWithItsPlace() {
        assertStarts("failure: it ends in an exception: java.lang.ArithmeticException: / by zero, in PlantedClasses.dividesByZero, line ",
                failure(PlantedClasses::dividesByZero));
    }
}
