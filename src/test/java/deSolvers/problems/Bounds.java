package deSolvers.problems;

import static org.junit.jupiter.api.Assertions.assertTrue;

/** Checks of what was measured: a failure shows the number and its bound. */
public final class Bounds {
    private Bounds() {
    }

    /**
     * @param bound  what it has to be less than
     * @param actual the number
     * @param which  whose number it is, where the test alone does not say it
     */
    public static void assertBelow(double bound, double actual, Object... which) {
        assertTrue(actual < bound, () -> actual + " is not below " + bound + of(which));
    }

    /** The same for a number that has to be more than the bound. */
    public static void assertAbove(double bound, double actual, Object... which) {
        assertTrue(actual > bound, () -> actual + " is not above " + bound + of(which));
    }

    /** The same for a number between two bounds. */
    public static void assertBetween(double low, double high, double actual, Object... which) {
        assertAbove(low, actual, which);
        assertBelow(high, actual, which);
    }

    private static String of(Object... which) {
        return which.length == 0 ? "" : ": " + which[0];
    }
}
