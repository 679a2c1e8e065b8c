package deSolvers.rungeKutta;

import java.util.ArrayList;
import java.util.List;

/**
 * The coefficients of an explicit Runge-Kutta method, read from a printed Butcher tableau:
 * <pre>
 *    0  |
 *   1/2 | 1/2
 *   ----+-------
 *       | 0   1
 * </pre>
 * Each line above the rule is c and the row of a; the lines below it are b and, where there are more, further weights
 * for the same stages.
 */
public final class ButcherTableau {
    private final double[] c;
    private final double[][] a;
    private final double[][] weights;
    private final int[] orders;

    private ButcherTableau(double[] c, double[][] a, double[][] weights, int[] orders) {
        this.c = c;
        this.a = a;
        this.weights = weights;
        this.orders = orders;
    }

    /**
     * Reads a tableau.
     *
     * @param printed the tableau; numbers are integers or fractions such as {@code -2187/6784}
     * @param orders  the order of the result with each line of weights
     * @return its coefficients
     * @throws IllegalArgumentException if the shape or a number is wrong
     */
    public static ButcherTableau parse(String printed, int... orders) {
        List<Double> nodes = new ArrayList<>();
        List<double[]> rows = new ArrayList<>();
        List<double[]> weights = new ArrayList<>();
        boolean below = false;
        for (String line : printed.strip().split("\n")) {
            if (line.strip().startsWith("--")) {
                below = true;
                continue;
            }
            int bar = line.indexOf('|');
            if (bar < 0) {
                throw new IllegalArgumentException("a line of a tableau has no '|': " + line);
            }
            double[] row = numbers(line.substring(bar + 1));
            if (!below) {
                nodes.add(number(line.substring(0, bar).strip()));
            }
            int expected = below ? nodes.size() : rows.size();
            if (row.length != expected) {
                throw new IllegalArgumentException("a line of a tableau has " + row.length + " numbers instead of "
                        + expected + ": " + line);
            }
            (below ? weights : rows).add(row);
        }
        if (weights.isEmpty() || weights.size() != orders.length) {
            throw new IllegalArgumentException("a tableau has " + weights.size() + " lines of weights below a rule and "
                    + orders.length + " orders:\n" + printed);
        }
        double[] c = nodes.stream().mapToDouble(Double::doubleValue).toArray();
        return new ButcherTableau(c, rows.toArray(new double[0][]), weights.toArray(new double[0][]),
                orders.clone());
    }

    private static double[] numbers(String text) {
        List<Double> numbers = new ArrayList<>();
        for (String word : text.strip().split("\\s+")) {
            if (!word.isEmpty()) {
                numbers.add(number(word));
            }
        }
        return numbers.stream().mapToDouble(Double::doubleValue).toArray();
    }

    /** Both parts of a fraction are exact, so the quotient is the double next to it. */
    private static double number(String text) {
        String[] parts = text.split("/");
        if (parts.length > 2) {
            throw new IllegalArgumentException("not a number of a tableau: " + text);
        }
        return parts.length == 1 ? Double.parseDouble(text)
                : Double.parseDouble(parts[0]) / Double.parseDouble(parts[1]);
    }

    /** @return the number of stages */
    public int stages() {
        return c.length;
    }

    /**
     * @param stage 0 to stages - 1
     * @return c, the stage's place within the step, 0 to 1
     */
    public double node(int stage) {
        return c[stage];
    }

    /**
     * @param stage 0 to stages - 1
     * @param of    an earlier stage
     * @return a, the weight of the earlier stage's slope in this stage's state
     */
    public double coefficient(int stage, int of) {
        return a[stage][of];
    }

    /**
     * @param line 0 for the method's own weights, 1 and on for the lines below
     * @return a copy of the line, one weight for each stage
     */
    public double[] weights(int line) {
        return weights[line].clone();
    }

    /**
     * @param line 0 for the method's own weights, 1 and on for the lines below
     * @return the order of the result with these weights
     */
    public int order(int line) {
        return orders[line];
    }

    /** @return the number of lines of weights, 1 or more */
    public int lines() {
        return weights.length;
    }
}
