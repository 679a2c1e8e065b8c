package deSolvers.adaptive;

/**
 * The error allowed for an entry s<sub>i</sub> of the state in a sub-step: absolute + relative max(|s<sub>i</sub>
 * before|, |s<sub>i</sub> after|).
 */
public final class Tolerance {
    private final double relative;
    private final double absolute;
    private int worstEntry = -1;

    /**
     * @param relative error allowed for an entry, relative to its size; 0 or more
     * @param absolute error allowed besides, in the entry's own unit; 0 or more
     * @throws IllegalArgumentException if one of them is negative or not finite, or both are 0
     */
    public Tolerance(double relative, double absolute) {
        if (!(relative >= 0 && absolute >= 0 && relative + absolute > 0 && relative + absolute <= Double.MAX_VALUE)) {
            throw new IllegalArgumentException("relativeTolerance " + relative + " and absoluteTolerance " + absolute
                    + ": both have to be finite numbers of 0 or more, and one of them more than 0");
        }
        this.relative = relative;
        this.absolute = absolute;
    }

    /** @return the error allowed for an entry, relative to its size */
    public double getRelative() {
        return relative;
    }

    /**
     * Computes the largest error relative to the tolerance.
     *
     * @param error  estimated error of every entry
     * @param before the state before the sub-step
     * @param after  the state after it
     * @return 0 or more; at most 1 if the sub-step is good enough; infinite if an error or a new entry is not finite
     */
    public double ratio(double[] error, double[] before, double[] after) {
        double largest = 0;
        worstEntry = error.length > 0 ? 0 : -1;
        for (int i = 0; i < error.length; i++) {
            double size = Math.max(Math.abs(before[i]), Math.abs(after[i]));
            double ratio = ratio(error[i], absolute + relative * size);
            if (!(size <= Double.MAX_VALUE && ratio <= Double.MAX_VALUE)) {
                worstEntry = i;
                return Double.POSITIVE_INFINITY;
            }
            if (ratio > largest) {
                largest = ratio;
                worstEntry = i;
            }
        }
        return largest;
    }

    /** Without an absolute tolerance, an entry that is 0 before and after has an error of 0. */
    private static double ratio(double error, double allowed) {
        return error == 0 ? 0 : Math.abs(error) / allowed;
    }

    /**
     * Computes the size of a vector relative to the tolerance of the state.
     *
     * @param vector any numbers
     * @param state  the state
     * @return the largest ratio, 0 or more
     */
    public double size(double[] vector, double[] state) {
        double largest = 0;
        for (int i = 0; i < vector.length; i++) {
            largest = Math.max(largest, ratio(vector[i], absolute + relative * Math.abs(state[i])));
        }
        return largest;
    }

    /** @return the entry with the largest ratio at the last call of {@link #ratio}; -1 for a state of size 0 */
    public int getWorstEntry() {
        return worstEntry;
    }
}
