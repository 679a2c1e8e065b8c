package particles.teaching.declared;

import deSolvers.DEStateSource;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.teaching.Formula;

/**
 * An explicit step as weights: where and when the derivatives are evaluated, and what the new state is.
 *
 * @param rows      for the state of each evaluation, and then for the new one, the weights of s and of k1, k2, ...,
 *                  which include deltaT; of particles that move in turns those of s, of v deltaT and a1 deltaT^2, a2
 *                  deltaT^2, ..., which move positions, and of a1 deltaT, a2 deltaT, ..., which change velocities
 * @param times     the times of the evaluations since the step began, in units of deltaT
 * @param particles whether positions and velocities move in turns; laws without drag do not see trial velocities
 */
public record Scheme(double[][] rows, double[] times, boolean particles) implements Step {

    /**
     * @param weights the weights of the new state
     * @param stages  those of the stages from the second one on
     * @return a Runge-Kutta method
     */
    static Scheme rungeKutta(double[] weights, double[]... stages) {
        int n = weights.length;
        double[][] rows = new double[n + 1][n + 1];
        for (int r = 0; r <= n; r++) {
            double[] row = r == 0 ? new double[0] : r < n ? stages[r - 1] : weights;
            rows[r][0] = 1;
            System.arraycopy(row, 0, rows[r], 1, row.length);
        }
        return new Scheme(rows, Arrays.stream(rows).limit(n).mapToDouble(row -> Arrays.stream(row).sum() - 1)
                .toArray(), false);
    }

    /**
     * @param drifts the drifts, x += v d deltaT, a first one before the first kick
     * @param kicks  the kicks, v += a k deltaT, between the drifts
     * @return a method of drifts and kicks in turn
     */
    public static Scheme turns(double[] drifts, double[] kicks) {
        int n = kicks.length;
        double[] reached = drifts.clone();
        Arrays.parallelPrefix(reached, Double::sum);
        double[][] rows = new double[n + 1][2 + 2 * n];
        for (int r = 0; r <= n; r++) {
            rows[r][0] = 1;
            rows[r][1] = reached[r];
            for (int c = 0; c < r; c++) {
                rows[r][2 + c] = kicks[c] * (reached[r] - reached[c]);
            }
        }
        System.arraycopy(kicks, 0, rows[n], 2 + n, n);
        return new Scheme(rows, Arrays.copyOf(reached, n), true);
    }

    /** @return the number of evaluations */
    public int size() {
        return times.length;
    }

    /** @return the column of the first derivative */
    public int first() {
        return particles ? 2 : 1;
    }

    /** The time to which a state belongs since the step began, in units of deltaT. */
    private double reached(int r) {
        return particles ? rows[r][1] : Arrays.stream(rows[r]).sum() - 1;
    }

    /** The clock at a state since the step began, in units of deltaT. */
    private double clock(int r) {
        return r < size() ? times[r] : 1;
    }

    /** @return the first state that belongs to another time than the clock, in a sentence */
    public Optional<String> astray() {
        return IntStream.rangeClosed(0, size()).filter(r -> !Formula.same(rows[r][0], 1) || !Formula.same(reached(r),
                clock(r))).mapToObj(r -> what(r) + " " + formula(r) + ": " + (Formula.same(rows[r][0], 1)
                ? "this state is that of " + Formula.time(reached(r)) : "the weight of the old state is " + Formula
                .number(rows[r][0]))).findFirst();
    }

    /** @return the same with another row */
    public Scheme with(int r, double[] row) {
        double[][] changed = rows.clone();
        changed[r] = row;
        return new Scheme(changed, times, particles);
    }

    /** @return the same at the times of another one with as many evaluations */
    public Scheme atTimesOf(Scheme other) {
        return new Scheme(rows, other.times, particles);
    }

    @Override
    public void make(DEStateSource source, double deltaT) {
        make(source, deltaT, k -> true);
    }

    /** Makes the step of the entries that move, while the others stand still. */
    public void make(DEStateSource source, double deltaT, IntPredicate moves) {
        double start = source.getTime();
        int n = size();
        double[] s = new double[source.getStateSize()];
        source.getState(s);
        double[][] columns = new double[rows[0].length][s.length];
        columns[0] = s;
        if (particles) {
            columns[1] = moved(s, deltaT);
        }
        for (int r = 0; r <= n; r++) {
            double[] row = rows[r];
            double[] next = new double[s.length];
            Arrays.setAll(next, k -> moves.test(k) ? IntStream.range(0, row.length).mapToDouble(c -> row[c]
                    * columns[c][k]).sum() : s[k]);
            source.setState(next);
            source.incTime(start + clock(r) * deltaT - source.getTime());
            if (r < n) {
                double[] f = new double[s.length];
                source.getStateDerivative(f);
                columns[first() + r] = moved(f, deltaT * deltaT);
                Arrays.setAll(columns[row.length - n + r], k -> particles && k % 6 < 3 ? 0 : deltaT * f[k]);
            }
        }
    }

    /** What the velocities among these numbers make of positions. */
    private static double[] moved(double[] numbers, double factor) {
        double[] positions = new double[numbers.length];
        Arrays.setAll(positions, k -> k % 6 < 3 && k + 3 < numbers.length ? factor * numbers[k + 3] : 0);
        return positions;
    }

    /** @return what a row says, such as {@code k2 = deltaT f is taken at} */
    public String what(int r) {
        return r == size() ? "the new state" + (particles ? " (x, v) is" : ", where each k includes deltaT, is")
                : (particles ? "the acceleration a" + (r + 1) : "k" + (r + 1) + " = deltaT f") + " is taken at";
    }

    /** @return a row as a formula, such as {@code (s + k1/2, t + deltaT/2)} */
    public String formula(int r) {
        double[] row = rows[r];
        int positions = first() + size();
        String whole = Formula.sum(Arrays.copyOf(row, positions), particles ? names("a", " deltaT^2", "x", "v deltaT")
                : names("k", "", "s"));
        double[] velocities = Arrays.copyOfRange(row, positions - 1, row.length);
        velocities[0] = row[0];
        return !particles && r == size() ? whole : "(" + whole + ", " + (r < size() ? Formula.time(times[r])
                : Formula.sum(velocities, names("a", " deltaT", "v"))) + ")";
    }

    private List<String> names(String letter, String unit, String... first) {
        return Stream.concat(Arrays.stream(first), IntStream.rangeClosed(1, size()).mapToObj(j -> letter + j + unit))
                .toList();
    }

    /** @return the first row that is another one, or at another time, than in a method of its kind and size; or -1 */
    public int unlike(Scheme other) {
        return IntStream.rangeClosed(0, size()).filter(r -> r < size() && !Formula.same(times[r], other.times[r])
                || !IntStream.range(0, rows[r].length).allMatch(c -> Formula.same(rows[r][c], other.rows[r][c])))
                .findFirst().orElse(-1);
    }
}
