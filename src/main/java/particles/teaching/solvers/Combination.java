package particles.teaching.solvers;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import particles.teaching.Formula;

/**
 * A sum of named things with weights, such as s + k1/2: where a derivative is evaluated, or the new state.
 *
 * @param what    what it says, such as "k2 is evaluated at"
 * @param names   the names of the things, the old state first
 * @param own     the place of the state that it moves
 * @param first   the place of the first derivative
 * @param weights their weights; may be fewer
 */
record Combination(String what, List<String> names, int own, int first, double[] weights) {
    private static final double SAME = 1e-9;
    /** What the rounding to eight digits adds up to: 5e-9 in Gill's method; 1/3 in float is 1e-8 off. */
    static final double PRINTED = 9e-9;

    /** @return the formula, such as s + k1/2 */
    String formula() {
        return Formula.sum(weights, names);
    }

    /** @return the places whose first eight digits are others than in another sum */
    int[] unlike(Combination other) {
        return IntStream.range(0, Math.max(weights.length, other.weights.length)).filter(j -> Math.abs(weight(j)
                - other.weight(j)) > PRINTED).toArray();
    }

    double weight(int j) {
        return j < weights.length ? weights[j] : 0;
    }

    /** @return the weights of so many derivatives */
    double[] slopes(int count) {
        return IntStream.range(first, first + count).mapToDouble(this::weight).toArray();
    }

    /** @return the sum of the weights of all but the old state, or position and velocity */
    double increment() {
        return sum(weights) - sum(Arrays.copyOf(weights, first));
    }

    /** @return how far it moves; a position, by the velocity alone */
    double moves() {
        return isPosition() ? weight(1) : increment();
    }

    boolean isPosition() {
        return first - own == 2;
    }

    /** @return the weight of the old state, which has to be 1 */
    double ofOwn() {
        return weight(own);
    }

    String state() {
        return names.get(own);
    }

    static boolean same(double[] x, double[] y) {
        return same(x, y, SAME);
    }

    /** @return whether they differ by no more than this, where missing numbers are 0 */
    static boolean same(double[] x, double[] y, double tolerance) {
        return Arrays.stream(plus(x, -1, y)).allMatch(off -> Math.abs(off) <= tolerance);
    }

    static double sum(double[] x) {
        return Arrays.stream(x).sum();
    }

    /** @return x + factor y, where missing numbers are 0 */
    static double[] plus(double[] x, double factor, double[] y) {
        double[] sum = Arrays.copyOf(x, Math.max(x.length, y.length));
        IntStream.range(0, y.length).forEach(j -> sum[j] += factor * y[j]);
        return sum;
    }
}
