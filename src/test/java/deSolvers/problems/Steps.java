package deSolvers.problems;

import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.DESolver;
import deSolvers.DEStateSource;
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

    /** Requires an exception whose message has a part, and returns it. */
    public static <T extends Throwable> T assertFails(Class<T> kind, String part, Executable call) {
        T e = assertThrows(kind, call);
        assertTrue(e.getMessage().contains(part), "'" + part + "' in: " + e.getMessage());
        return e;
    }
}
