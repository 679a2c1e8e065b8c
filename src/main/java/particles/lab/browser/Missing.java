package particles.lab.browser;

import deSolvers.DESolver;

/** What a browser page has instead of some of the JDK's methods, with the same names and parameters. */
public final class Missing {
    private static final long MEMORY = 1L << 30;

    private Missing() {
    }

    /** @return a b + c, rounded twice, where Java's rounds once: processors' fused operation is not open to pages */
    public static double fma(double a, double b, double c) {
        return a * b + c;
    }

    /** @return how much memory a run may take (bytes); a page is not told, and this is what any can have */
    public static long maxMemory() {
        return MEMORY;
    }

    /** @return a student's solver */
    public static DESolver ofClass(String name, Double... tolerances) {
        return PageClasses.solver(name, tolerances);
    }
}
