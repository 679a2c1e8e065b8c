package deSolvers;

/** Looks for numbers that are not numbers any more; made for arrays that hardly ever have any. */
public final class FiniteCheck {
    private FiniteCheck() {
    }

    /**
     * @param values any numbers
     * @return the index of the first one that is NaN or infinite, or -1
     */
    public static int firstNonFinite(double[] values) {
        if (values.length == 2) {                       // the slides' oscillator: a loop costs more than a whole step of it
            return Math.fma(values[0], 0, values[1] * 0) == 0 ? -1 : find(values);
        }
        return firstOfMany(values);
    }

    /**
     * Looks at two arrays at once, which on small ones takes half the time.
     *
     * @param a any numbers
     * @param b others
     * @return whether all of them are finite
     */
    public static boolean areFinite(double[] a, double[] b) {
        if (a.length == 2 && b.length == 2) {
            return Math.fma(a[0], 0, a[1] * 0) + Math.fma(b[0], 0, b[1] * 0) == 0;
        }
        return firstNonFinite(a) < 0 && firstNonFinite(b) < 0;
    }

    private static int firstOfMany(double[] values) {
        int n = values.length;
        double a = 0;                                   // 0 times a finite number is 0, times any other NaN; eight sums, since
        double b = 0;                                   // each addition waits for the one before
        double c = 0;
        double d = 0;
        double e = 0;
        double f = 0;
        double g = 0;
        double h = 0;
        int last = n & ~7;
        for (int i = 0; i < last; i += 8) {
            a = Math.fma(values[i], 0, a);
            b = Math.fma(values[i + 1], 0, b);
            c = Math.fma(values[i + 2], 0, c);
            d = Math.fma(values[i + 3], 0, d);
            e = Math.fma(values[i + 4], 0, e);
            f = Math.fma(values[i + 5], 0, f);
            g = Math.fma(values[i + 6], 0, g);
            h = Math.fma(values[i + 7], 0, h);
        }
        for (int i = last; i < n; i++) {
            a = Math.fma(values[i], 0, a);
        }
        return (a + b) + (c + d) + ((e + f) + (g + h)) == 0 ? -1 : find(values);
    }

    private static int find(double[] values) {
        int i = 0;
        while (Double.isFinite(values[i])) {
            i++;
        }
        return i;
    }
}
