package particles.teaching.solvers;

import deSolvers.DESolver;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import particles.teaching.Formula;
import particles.teaching.sources.Probe;
import particles.teaching.sources.SecondOrderProbe;

/**
 * The coefficients of one step of a method that distinguishes positions from velocities, for accelerations that do not
 * depend on the velocity: the new position is x + p v h + h^2 sum x_j a_j, the new velocity v + h sum v_j a_j, and a_j
 * is the acceleration at the position x + p_j v h + h^2 sum x_jk a_k and the time t + c_j h.
 *
 * @param x      the weights of the new position
 * @param v      the weights of the new velocity
 * @param p      the weight of the old velocity in the new position
 * @param at     the weights in the position of each evaluation
 * @param pAt    the weight of the old velocity in it
 * @param c      the clock of each evaluation, since the step began
 * @param end    the clock at the end
 * @param kept   the weight of the old position, and of the old velocity, in the new one
 * @param left   whether the state was not set after the last evaluation
 */
record ExtractedKicks(double[] x, double[] v, double p, double[][] at, double[] pAt, double[] c, double end,
        double[] kept,
        boolean left) {
    private static final int BLOCKS = Probe.MOST_EVALUATIONS + 3;
    private static final int OLD_POSITION = BLOCKS - 2;
    private static final int OLD_VELOCITY = BLOCKS - 1;
    private static final double START = 2;

    /**
     * Makes one step.
     *
     * @param solver    a new solver
     * @param h         deltaT, a power of 2 (s)
     * @param dimension the number of positions in a block
     * @return the coefficients
     * @throws RuntimeException any exception of the solver
     */
    static ExtractedKicks of(DESolver solver, double h, int dimension) {
        int width = 2 * dimension;
        double[] start = new double[BLOCKS * width];
        start[OLD_POSITION * width] = 1;
        start[OLD_VELOCITY * width + dimension] = 1;
        Probe probe = new SecondOrderProbe(start, dimension, START, (evaluation, dSdt) -> dSdt[(1 + evaluation) * width
                + dimension] = 1);
        solver.stepState(probe, h);
        int stages = probe.recorded().size();
        double[] last = probe.state();
        double[] x = new double[stages];
        double[] v = new double[stages];
        double[][] at = new double[stages][stages];
        double[] pAt = new double[stages];
        double[] c = new double[stages];
        for (int j = 0; j < stages; j++) {
            Probe.Evaluation evaluation = probe.recorded().get(j);
            x[j] = last[(1 + j) * width] / (h * h);
            v[j] = last[(1 + j) * width + dimension] / h;
            c[j] = (evaluation.time() - START) / h;
            pAt[j] = evaluation.state()[OLD_VELOCITY * width] / h;
            for (int k = 0; k < stages; k++) {
                at[j][k] = evaluation.state()[(1 + k) * width] / (h * h);
            }
        }
        return new ExtractedKicks(x, v, last[OLD_VELOCITY * width] / h, at, pAt, c, (probe.getTime() - START) / h,
                new double[] {last[OLD_POSITION * width], last[OLD_VELOCITY * width + dimension]},
                        !probe.setAfterLast());
    }

    /** @return the same with one evaluation for each state and time, without evaluations that are not used */
    ExtractedKicks merged() {
        int n = v.length;
        List<Integer> kept = new ArrayList<>();
        double[][] rows = new double[n][n];
        double[] newX = x.clone();
        double[] newV = v.clone();
        int[] same = new int[n];
        for (int j = 0; j < n; j++) {
            for (int k = 0; k < j; k++) {
                rows[j][same[k]] += at[j][k];
            }
            same[j] = j;
            for (int other : kept) {
                if (MethodDifferences.same(rows[j], rows[other]) && Formula.same(pAt[j], pAt[other])
                        && Formula.sameTime(c[j], c[other])) {
                    same[j] = other;
                }
            }
            if (same[j] == j) {
                kept.add(j);
            } else {
                newX[same[j]] += newX[j];
                newV[same[j]] += newV[j];
            }
        }
        kept.removeIf(j -> newX[j] == 0 && newV[j] == 0 && kept.stream().allMatch(k -> rows[k][j] == 0));
        return new ExtractedKicks(pick(newX, kept), pick(newV, kept), p,
                kept.stream().map(j -> pick(rows[j], kept)).toArray(double[][]::new), pick(pAt, kept), pick(c, kept),
                        end,
                this.kept, left);
    }

    private static double[] pick(double[] from, List<Integer> places) {
        return places.stream().mapToDouble(j -> from[j]).toArray();
    }

    /**
     * Makes a step with random numbers, and compares all states that the solver sets with those by these coefficients.
     *
     * @param size the size of the accelerations
     * @return the comparisons of the positions at the evaluations, then that of the new state; empty if the number of
     *         evaluations is another one
     */
    List<EntryComparison> compare(DESolver solver, double h, int dimension, double size) {
        Random random = new Random(2003);
        int width = 2 * dimension;
        double[] start = random.doubles(BLOCKS * width, 1, 2).toArray();
        double[][] accelerations = new double[Probe.MOST_EVALUATIONS][];
        for (int j = 0; j < accelerations.length; j++) {
            accelerations[j] = random.doubles(start.length, -size, size).toArray();
        }
        Probe probe = new SecondOrderProbe(start, dimension, START, (j, dSdt) -> System.arraycopy(accelerations[j], 0,
                dSdt, 0, dSdt.length));
        solver.stepState(probe, h);
        List<EntryComparison> all = new ArrayList<>();
        if (probe.recorded().size() != v.length) {
            return all;
        }
        for (int i = 0; i <= v.length; i++) {
            boolean end = i == v.length;
            double[] found = end ? probe.state() : probe.recorded().get(i).state();
            double[] without = start.clone();
            double[] expected = new double[start.length];
            double[] added = new double[start.length];
            for (int k = 0; k < start.length; k++) {
                boolean position = k % width < dimension;
                double[] weights = !position ? v : end ? x : at[i];
                without[k] += position ? h * (end ? p : pAt[i]) * start[k + dimension] : 0;
                expected[k] = without[k] + (end ? (kept[position ? 0 : 1] - 1) * start[k] : 0);
                added[k] = 1;
                for (int j = 0; j < v.length; j++) {
                    expected[k] += position ? h * h * weights[j] * accelerations[j][k + dimension]
                            : h * weights[j] * accelerations[j][k];
                }
                if (!position && !end) {                // half of the kicks may be made
                    expected[k] = found[k];
                }
            }
            all.add(EntryComparison.of(expected, without, start, added, found));
        }
        return all;
    }
}
