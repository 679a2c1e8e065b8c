package deSolvers;

/** A search for NaN and infinity in arrays that hardly ever have any. */
public final class FiniteCheck {
    private FiniteCheck() {
    }

    /**
     * @param values any numbers
     * @return the index of the first one that is NaN or infinite, or -1
     */
    public static int firstNonFinite(double[] values) {
        for (int i = 0; i < values.length; i++) {
            if (!Double.isFinite(values[i])) {
                return i;
            }
        }
        return -1;
    }
}
