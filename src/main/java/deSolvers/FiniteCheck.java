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
        double even = 0;                                // 0 times a finite number is 0, times any other NaN; two sums, since
        double odd = 0;                                 // each addition waits for the one before
        int n = values.length;
        for (int i = 0; i + 1 < n; i += 2) {
            even += values[i] * 0;
            odd += values[i + 1] * 0;
        }
        if (even + odd + (n % 2 == 1 ? values[n - 1] * 0 : 0) == 0) {
            return -1;
        }
        int i = 0;
        while (Double.isFinite(values[i])) {
            i++;
        }
        return i;
    }
}
