package particles.teaching.solvers;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import particles.teaching.Finding;
import particles.teaching.Finding.Kind;

/**
 * A state that a solver set, compared entry by entry with the one that its coefficients give.
 *
 * @param left    the entries that a loop left out: without any derivative in them, or 0
 * @param largest the largest difference of the others, relative to the numbers that are added
 * @param size    the number of entries
 */
record EntryComparison(List<Integer> left, double largest, int size) {
    private static final double ROUNDING = 1e-12;
    private static final int MOST_SHOWN = 6;

    /**
     * @param expected the state by the coefficients
     * @param without  the same without derivatives
     * @param start    the state before the step
     * @param added    by entry, the sum of the sizes of all numbers in it
     * @param found    the state that was set
     */
    static EntryComparison of(double[] expected, double[] without, double[] start, double[] added, double[] found) {
        List<Integer> left = new ArrayList<>();
        double largest = 0;
        for (int k = 0; k < found.length; k++) {
            double difference = Math.abs(found[k] - expected[k]) / added[k];
            if (difference > ROUNDING && (found[k] == without[k] || found[k] == start[k] || found[k] == 0)) {
                left.add(k);
            } else {
                largest = Math.max(largest, difference);
            }
        }
        return new EntryComparison(left, largest, found.length);
    }

    boolean isWithout(double rounding) {
        return left.size() == size || !(largest <= rounding);
    }

    /**
     * @param states the comparisons of the states of the evaluations, then that of the new state
     * @return the mistakes of loops that left out some entries, where the others agree up to the rounding
     */
    static List<Finding> leftOut(List<EntryComparison> states, double rounding) {
        return IntStream.range(0, states.size()).filter(i -> !states.get(i).left.isEmpty()
                && !states.get(i).isWithout(rounding)).mapToObj(i -> new Finding(Kind.STATE, states.get(i).text()
                + (i == states.size() - 1 ? "the new state" : "the trial state at evaluation " + (i + 1))
                + ": the loop has to reach all entries, from 0 to source.getStateSize() - 1")).toList();
    }

    private String text() {
        boolean one = left.size() == 1;
        int last = left.get(left.size() - 1);
        boolean row = last - left.get(0) == left.size() - 1 && left.size() > 2;
        String numbers = row ? left.get(0) + " to " + last : left.stream().limit(MOST_SHOWN).toList().toString()
                .replaceAll("[\\[\\]]", "") + (left.size() > MOST_SHOWN ? "..." : "");
        return (one ? "entry " : "entries ") + numbers + " of " + size + (one ? " stays as it was in "
                : " stay as they were in ");
    }
}
