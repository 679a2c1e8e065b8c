package particles.teaching.declared;

import deSolvers.DEStateSource;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import particles.teaching.Formula;

/**
 * An explicit step as weights: where and when the derivatives are evaluated, and what the new state is.
 *
 * @param rows      the weights of s, then those of k1, k2, ..., which include deltaT: a row for the state of each
 *                  evaluation, then that of the new state. Of particles that move in turns, the weights of x, of
 *                  v deltaT, and of the accelerations in units of deltaT^2: a row for the position of each evaluation,
 *                  then that of the new position; at last that of the new velocity, with the accelerations in units of
 *                  deltaT
 * @param times     the times of the evaluations since the step began, in units of deltaT
 * @param particles whether positions and velocities move in turns
 */
public record Scheme(List<double[]> rows, double[] times, boolean particles) implements Step {

    /**
     * @param weights the weights of the new state
     * @param stages  those of the stages from the second one on
     * @return a Runge-Kutta method
     */
    static Scheme rungeKutta(double[] weights, double[]... stages) {
        List<double[]> rows = new ArrayList<>(List.of(new double[] {1}));
        for (double[] row : stages) {
            rows.add(row(1, row));
        }
        double[] times = rows.stream().mapToDouble(row -> sum(row) - 1).toArray();
        rows.add(row(1, weights));
        return new Scheme(rows, times, false);
    }

    /**
     * @param drifts the drifts, x += v d deltaT, a first one before the first kick
     * @param kicks  the kicks, v += a k deltaT, between the drifts
     * @return a method of drifts and kicks in turn
     */
    public static Scheme turns(double[] drifts, double[] kicks) {
        double[] reached = drifts.clone();
        Arrays.parallelPrefix(reached, Double::sum);
        List<double[]> rows = new ArrayList<>();
        for (double place : reached) {
            double[] row = new double[2 + rows.size()];
            Arrays.setAll(row, c -> c == 0 ? 1 : c == 1 ? place : kicks[c - 2] * (place - reached[c - 2]));
            rows.add(row);
        }
        double[] velocity = row(0, row(1, kicks));
        rows.add(velocity);
        return new Scheme(rows, Arrays.copyOf(reached, kicks.length), true);
    }

    private static double[] row(double first, double[] others) {
        double[] row = new double[others.length + 1];
        row[0] = first;
        System.arraycopy(others, 0, row, 1, others.length);
        return row;
    }

    public static double sum(double[] row) {
        return Arrays.stream(row).sum();
    }

    /** @return the number of evaluations */
    public int size() {
        return times.length;
    }

    /** @return the column of the first derivative */
    public int first() {
        return particles ? 2 : 1;
    }

    /** @return the column of the state that a row moves */
    public int own(int r) {
        return r > size() ? 1 : 0;
    }

    /** @return the same with another row */
    public Scheme with(int r, double[] row) {
        List<double[]> changed = new ArrayList<>(rows);
        changed.set(r, row);
        return new Scheme(changed, times, particles);
    }

    /** @return the same with other times */
    public Scheme at(double... others) {
        return new Scheme(rows, others, particles);
    }

    @Override
    public void make(DEStateSource source, double deltaT) {
        double start = source.getTime();
        double[] s = new double[source.getStateSize()];
        source.getState(s);
        double[][] f = new double[size()][s.length];
        for (int j = 0; j < size(); j++) {
            source.setState(state(s, f, j, deltaT));
            source.incTime(start + times[j] * deltaT - source.getTime());
            source.getStateDerivative(f[j]);
        }
        source.setState(state(s, f, size(), deltaT));
        source.incTime(start + deltaT - source.getTime());
    }

    /** The state of an evaluation or the new one. A law without drag does not see the trial velocities of turns. */
    private double[] state(double[] s, double[][] f, int r, double h) {
        double[] next = s.clone();
        for (int k = 0; k < s.length; k++) {
            boolean position = particles && k % 6 < 3;
            boolean velocity = particles && !position;
            if (velocity && r < size()) {
                continue;
            }
            double[] row = rows.get(velocity ? r + 1 : r);
            next[k] = row[velocity ? 1 : 0] * s[k] + (position ? row[1] * h * s[k + 3] : 0);
            for (int c = first(); c < row.length; c++) {
                next[k] += row[c] * h * (position ? h * f[c - 2][k + 3] : f[c - first()][k]);
            }
        }
        return next;
    }

    /** @return what a row says, such as {@code k2 = deltaT f is taken at} */
    public String what(int r) {
        return r > size() ? "the new velocity is" : r == size() ? particles ? "the new position is"
                : "the new state, where each k includes deltaT, is" : (particles ? "the acceleration a" + (r + 1)
                : "k" + (r + 1) + " = deltaT f") + " is taken at";
    }

    /** @return a row as a formula, such as {@code s + k1/2} */
    public String formula(int r) {
        boolean velocity = r > size();
        List<String> names = new ArrayList<>(!particles ? List.of("s") : List.of("x", velocity ? "v" : "v deltaT"));
        IntStream.rangeClosed(1, size()).forEach(j -> names.add(!particles ? "k" + j : "a" + j + (velocity ? " deltaT"
                : " deltaT^2")));
        return Formula.sum(rows.get(r), names);
    }

    /** @return the first row that is another one than in a method of the same kind; -1 if none is */
    public int unlike(Scheme other) {
        return IntStream.range(0, Math.min(rows.size(), other.rows.size())).filter(r -> !same(rows.get(r),
                other.rows.get(r))).findFirst().orElse(-1);
    }

    /** @return whether two rows are equal up to round-off, where missing numbers are 0 */
    public static boolean same(double[] x, double[] y) {
        return IntStream.range(0, Math.max(x.length, y.length)).allMatch(j -> Formula.same(j < x.length ? x[j] : 0,
                j < y.length ? y[j] : 0));
    }
}
