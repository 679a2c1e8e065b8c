package deSolvers;

/** Looks for NaN and infinity in arrays that hardly ever have any. */
public final class FiniteCheck {
    private FiniteCheck() {
    }

    /**
     * @param values any numbers
     * @return the index of the first one that is NaN or infinite, or -1
     */
    public static int firstNonFinite(double[] values) {
        int n = values.length;
        double a = 0;                                   // 0 times a finite number is 0, times any other NaN
        double b = 0;                                   // four sums, since each addition waits for the one before
        double c = 0;
        double d = 0;
        int i = 0;
        for (; i + 3 < n; i += 4) {
            a += 0 * values[i];
            b += 0 * values[i + 1];
            c += 0 * values[i + 2];
            d += 0 * values[i + 3];
        }
        for (; i < n; i++) {
            a += 0 * values[i];
        }
        return (a + b) + (c + d) == 0 ? -1 : find(values);
    }

    private static int find(double[] values) {
        int i = 0;
        while (Double.isFinite(values[i])) {
            i++;
        }
        return i;
    }
}
