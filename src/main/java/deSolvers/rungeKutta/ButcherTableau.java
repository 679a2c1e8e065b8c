package deSolvers.rungeKutta;

import deSolvers.StepTransaction;
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

    /** The loop over the stages of any explicit Runge-Kutta method, with its work arrays. */
    public static final class Stages {
        private final ButcherTableau tableau;
        private final double[][] k;
        private double[] trial = {};

        /** @param tableau the method */
        public Stages(ButcherTableau tableau) {
            this.tableau = tableau;
            this.k = new double[tableau.c.length][0];
        }

        /** @param n the state's size from now on */
        public void resize(int n) {
            trial = new double[n];
            for (int i = 0; i < k.length; i++) {
                k[i] = new double[n];
            }
        }

        /**
         * Evaluates all stages but the first, whose slope is known.
         *
         * @param source the step's source; left at the last stage
         * @param state  the state at the beginning
         * @param slope  the derivative there
         * @param offset time from the beginning of the step to that of the sub-step (s)
         * @param h      the sub-step (s)
         */
        public void evaluate(StepTransaction source, double[] state, double[] slope, double offset, double h) {
            System.arraycopy(slope, 0, k[0], 0, slope.length);
            for (int stage = 1; stage < k.length; stage++) {
                combine(tableau.a[stage], h, trial);
                for (int i = 0; i < trial.length; i++) {
                    trial[i] += state[i];
                }
                source.setState(trial);
                source.setOffset(offset + tableau.c[stage][0] * h);
                source.getStateDerivative(k[stage]);        // at (s + h sum a k, t + c h)
            }
        }

        /**
         * Computes a weighted sum of the slopes.
         *
         * @param weights the weights of the first stages
         * @param h       a factor for all (s)
         * @param result  receives h sum w k
         */
        public void combine(double[] weights, double h, double[] result) {
            Arrays.fill(result, 0);
            for (int j = 0; j < weights.length; j++) {
                double weight = weights[j];
                for (int i = 0; weight != 0 && i < result.length; i++) {
                    result[i] += weight * k[j][i];
                }
            }
            for (int i = 0; i < result.length; i++) {
                result[i] *= h;
            }
        }

        /** @return the state of the last stage evaluated; to be read only */
        public double[] getLastState() {
            return trial;
        }

        /**
         * @param stage 0 to stages - 1
         * @return its slope; to be read only
         */
        public double[] slope(int stage) {
            return k[stage];
        }
    }
}
