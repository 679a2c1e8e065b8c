package particles.experiments.runs;

import java.util.function.IntPredicate;

/** Finds the fewest steps that are enough. */
public final class FewestSteps {
    private FewestSteps() {
    }

    /**
     * Doubles a number of steps until it is enough, and bisects the last interval.
     *
     * @param first  the first number, 2 or more
     * @param most   the largest number to try
     * @param near   the search ends where a number that is not enough is less by this factor or by one step
     * @param enough whether a number of steps is enough; if it is, so are more
     * @return the number; 0 if none is enough
     */
    public static int find(int first, int most, double near, IntPredicate enough) {
        int high = first;
        while (!enough.test(high)) {
            high *= 2;
            if (high > most) {
                return 0;
            }
        }
        int low = high / 2;
        while (high > near * low + 1) {
            int middle = (low + high) / 2;
            if (enough.test(middle)) {
                high = middle;
            } else {
                low = middle;
            }
        }
        return high;
    }
}
