package deSolvers;

/** A fast search for NaN and infinity in arrays that hardly ever have any. */
public final class FiniteCheck {
    private FiniteCheck() {
    }

    /**
     * @param values any numbers
     * @return the index of the first one that is NaN or infinite, or -1
     */
    public static int firstNonFinite(double[] values) {
        // the sum of finite numbers may overflow, but of no others is finite
        return sum(values) * 0 == 0 ? -1 : find(values);
    }

    /** Eight sums, since each addition waits for the one before. */
    private static double sum(double[] values) {
        int n = values.length;
        double a = 0;
        double b = 0;
        double c = 0;
        double d = 0;
        double e = 0;
        double f = 0;
        double g = 0;
        double h = 0;
        int i = 0;
        for (; i + 7 < n; i += 8) {
            a += values[i];
            b += values[i + 1];
            c += values[i + 2];
            d += values[i + 3];
            e += values[i + 4];
            f += values[i + 5];
            g += values[i + 6];
            h += values[i + 7];
        }
        for (; i < n; i++) {
            a += values[i];
        }
        return (a + b) + (c + d) + ((e + f) + (g + h));
    }

    private static int find(double[] values) {
        for (int i = 0; i < values.length; i++) {
            if (!Double.isFinite(values[i])) {
                return i;
            }
        }
        return -1;
    }
}
