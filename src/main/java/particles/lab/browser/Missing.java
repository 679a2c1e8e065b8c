package particles.lab.browser;

import deSolvers.DESolver;
import java.util.NoSuchElementException;
import java.util.function.Supplier;

/** Replaces methods that a page lacks, or that are wrong or slow there, by methods of the same names and parameters. */
public final class Missing {
    private static final long MEMORY = 1L << 30;

    private Missing() {
    }

    /** @return a b + c, rounded twice, where Java's rounds once: processors' fused operation is not open to pages */
    public static double fma(double a, double b, double c) {
        return a * b + c;
    }

    /** @return the distance to the next larger number; that of the page's library is wrong for most numbers */
    public static double ulp(double a) {
        double size = Math.abs(a);
        double next = Math.nextUp(size);
        return next <= Double.MAX_VALUE ? next - size : size - Math.nextDown(size);
    }

    /**
     * Tests the length of a spring without 64-bit integers: in a page they are objects, which took 0.4 of the time of
     * the cloth in wind.
     *
     * @return whether the square of a length neither overflows nor loses digits
     */
    public static boolean isOrdinary(double square) {
        return square >= 1e-280 && square < 1e280;
    }

    /** @return the memory that a run may take (bytes); a page cannot ask, and most pages can have this */
    public static long maxMemory() {
        return MEMORY;
    }

    /** @return a student's solver, in the place of one that is found by reflection; it has no tolerances */
    public static DESolver ofClass(String name, Double... tolerances) {
        Supplier<DESolver> maker = Students.SOLVERS.get(name);
        if (maker == null) {
            throw new NoSuchElementException(name + " is not in this page; type: gradle lab -Psolver=" + name);
        }
        if (tolerances.length > 0) {
            throw new IllegalArgumentException("a solver of your own takes no tolerances in this page");
        }
        return maker.get();
    }
}
