package deSolvers.problems;

import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import deSolvers.DESolver;
import deSolvers.DEStateSource;
import java.lang.management.ManagementFactory;
import java.util.function.DoublePredicate;
import org.junit.jupiter.api.function.Executable;

/** Steps that tests make, and those that have to fail. */
public final class Steps {
    private Steps() {
    }

    /** Makes some equal steps. */
    public static void make(int count, DESolver solver, DEStateSource source, double deltaT) {
        for (int k = 0; k < count; k++) {
            solver.stepState(source, deltaT);
        }
    }

    /** The bytes that this thread allocates in some equal steps. */
    public static long allocatedIn(int count, DESolver solver, DEStateSource source, double deltaT) {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long before = threads.getCurrentThreadAllocatedBytes();
        make(count, solver, source, deltaT);
        return threads.getCurrentThreadAllocatedBytes() - before;
    }

    /** Returns, by bisection, the largest number between two at which something holds that holds at all below it. */
    public static double bisect(double least, double most, DoublePredicate holds) {
        double low = least;
        double high = most;
        for (int k = 0; k < 60; k++) {
            double middle = (low + high) / 2;
            if (holds.test(middle)) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return low;
    }

    /** Requires an IllegalArgumentException of each. */
    public static void assertRefused(Executable... calls) {
        for (int k = 0; k < calls.length; k++) {
            assertThrows(IllegalArgumentException.class, calls[k], "call " + k);
        }
    }

    /** Requires an exception whose message has a part, and returns it. */
    public static <T extends Throwable> T assertFails(Class<T> kind, String part, Executable call) {
        T e = assertThrows(kind, call);
        assertTrue(e.getMessage().contains(part), "'" + part + "' in: " + e.getMessage());
        return e;
    }
}
