package deSolvers.rungeKutta;

import java.util.Arrays;

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
    private final double[][] c;
    private final double[][] a;
    private final double[][] weights;

    private ButcherTableau(double[][] c, double[][] a, double[][] weights) {
        this.c = c;
        this.a = a;
        this.weights = weights;
    }

    /**
     * Reads a tableau.
     *
     * @param printed the tableau; numbers are integers or fractions such as {@code -2187/6784}
     * @return its coefficients
     * @throws IllegalArgumentException if a line has too few or too many numbers
     */
    public static ButcherTableau parse(String printed) {
        String[] parts = printed.split("(?m)^\\s*-[-+]*\\s*$");
        ButcherTableau tableau = new ButcherTableau(numbers(parts[0], 0), numbers(parts[0], 1),
                numbers(parts[parts.length - 1], 1));
        for (int stage = 0; stage < tableau.getStages(); stage++) {
            require(tableau.c[stage], 1);
            require(tableau.a[stage], stage);
        }
        for (double[] line : tableau.weights) {
            require(line, tableau.getStages());
        }
        return tableau;
    }

    private static void require(double[] line, int length) {
        if (line.length != length) {
            throw new IllegalArgumentException("a line of a tableau has " + line.length + " numbers instead of "
                    + length + ": " + Arrays.toString(line));
        }
    }

    /** The numbers left or right of the bar. */
    private static double[][] numbers(String lines, int side) {
        return Arrays.stream(lines.strip().split("\n")).map(line -> (line + "|").split("[|]", 3)[side])
                .map(text -> Arrays.stream(text.split("\\s+")).filter(word -> !word.isEmpty())
                        .mapToDouble(ButcherTableau::number).toArray()).toArray(double[][]::new);
    }

    /** Both parts of a fraction are exact, so the quotient is the double next to it. */
    private static double number(String text) {
        int slash = text.indexOf('/');
        return slash < 0 ? Double.parseDouble(text)
                : Double.parseDouble(text.substring(0, slash)) / Double.parseDouble(text.substring(slash + 1));
    }

    /** @return the number of stages */
    public int getStages() {
        return c.length;
    }

    /**
     * @param stage 0 to stages - 1
     * @return c, the stage's place within the step, 0 to 1
     */
    public double node(int stage) {
        return c[stage][0];
    }

    /**
     * @param stage 0 to stages - 1
     * @return a's row, the weights of the earlier stages' slopes in this stage's state; not to be changed
     */
    public double[] row(int stage) {
        return a[stage];
    }

    /**
     * @param line 0 for the method's own weights, 1 and on for the lines below
     * @return a copy of the line, one weight for each stage
     */
    public double[] weights(int line) {
        return weights[line].clone();
    }
}
