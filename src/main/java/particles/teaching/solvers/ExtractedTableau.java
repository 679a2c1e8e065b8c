package particles.teaching.solvers;

import deSolvers.DESolver;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import particles.teaching.sources.Probe;

/**
 * The coefficients of one step of an explicit one-step method, read from the states that it sets: the state at
 * evaluation i is s + sum a_ij f_j at time t + c_i, the new state s + sum b_j f_j. All contain deltaT.
 *
 * @param h            deltaT (s)
 * @param a            a row for each evaluation
 * @param b            the weights of the new state
 * @param c            the clock at each evaluation, since the step began (s)
 * @param end          the clock at the end, since the step began (s)
 * @param kept         the weight of the old state in the new one; 1 is right
 * @param keptAt       the weight of the old state in the state of each evaluation
 * @param stateSet     whether the state was set before each evaluation
 * @param setAfterLast whether it was set after the last one
 * @param everSet      whether it was set at all
 * @param clockMoves   the movements of the clock (s)
 * @param wrongLengths the lengths of arrays that were not as long as the state
 */
record ExtractedTableau(double h, double[][] a, double[] b, double[] c, double end, double kept, double[] keptAt,
                        boolean[] stateSet, boolean setAfterLast, boolean everSet, List<Double> clockMoves,
                        List<Integer> wrongLengths) {
    /** The size of the state: three blocks of six and one more, whatever a solver assumes about particles. */
    private static final int SIZE = 24;
    private static final int KEPT = 20;
    /** The clock at the start (s). */
    static final double START = 2;

    /**
     * Makes one step.
     *
     * @param solver a new solver
     * @param h      deltaT, a power of 2, so that nothing is rounded (s)
     * @param size   the size of the derivatives, a power of 2; with small ones an adaptive method accepts its first
     *               step
     * @return the coefficients
     * @throws RuntimeException any exception of the solver
     */
    static ExtractedTableau of(DESolver solver, double h, double size) {
        double[] start = new double[SIZE];
        start[KEPT] = 1;
        Probe probe = new Probe(start, START, (evaluation, dSdt) -> dSdt[1 + evaluation] = size);
        solver.stepState(probe, h);
        List<Probe.Evaluation> evaluations = probe.recorded();
        int stages = evaluations.size();
        double[][] a = new double[stages][];
        double[] c = new double[stages];
        double[] keptAt = new double[stages];
        boolean[] stateSet = new boolean[stages];
        for (int i = 0; i < stages; i++) {
            Probe.Evaluation evaluation = evaluations.get(i);
            a[i] = coefficients(evaluation.state(), stages, size);
            c[i] = evaluation.time() - START;
            keptAt[i] = evaluation.state()[KEPT];
            stateSet[i] = evaluation.stateSet();
        }
        double[] last = probe.state();
        return new ExtractedTableau(h, a, coefficients(last, stages, size), c, probe.getTime() - START, last[KEPT],
                keptAt,
                stateSet, probe.setAfterLast(), probe.everSet(), probe.clockMoves(), probe.wrongLengths());
    }

    private static double[] coefficients(double[] state, int stages, double size) {
        return Arrays.stream(state, 1, 1 + stages).map(x -> x / size).toArray();
    }

    /** @return whether the state is evaluated and stays where it was */
    boolean isStill() {
        return stages() > 0 && everSet && Arrays.stream(b).allMatch(weight -> weight == 0);
    }

    int stages() {
        return b.length;
    }

    /**
     * Makes a step with numbers that use all digits of a double, and compares all states that the solver sets with
     * those by these coefficients.
     *
     * @param solver a new solver
     * @param size   the size of the derivatives
     * @return the comparisons of the states of the evaluations, then that of the new state; empty if the number of
     *         evaluations is another one
     */
    List<EntryComparison> compare(DESolver solver, double size) {
        Random random = new Random(2003);
        double[] start = random.doubles(SIZE, 1, 2).map(x -> x * Math.min(1, size)).toArray();
        double[][] slopes = new double[Probe.MOST_EVALUATIONS][];
        for (int j = 0; j < slopes.length; j++) {
            slopes[j] = random.doubles(SIZE, -size, size).toArray();
        }
        Probe probe = new Probe(start, START, (j, dSdt) -> System.arraycopy(slopes[j], 0, dSdt, 0, SIZE));
        solver.stepState(probe, h);
        List<EntryComparison> all = new ArrayList<>();
        if (probe.recorded().size() == stages()) {
            for (int i = 0; i < stages(); i++) {
                all.add(compare(start, 1, a[i], slopes, probe.recorded().get(i).state()));
            }
            all.add(compare(start, kept, b, slopes, probe.state()));
        }
        return all;
    }

    private static EntryComparison compare(double[] start, double kept, double[] weights, double[][] slopes,
            double[] found) {
        double[] expected = new double[SIZE];
        double[] added = new double[SIZE];
        for (int k = 0; k < SIZE; k++) {
            expected[k] = kept * start[k];
            added[k] = Math.abs(start[k]);
            for (int j = 0; j < weights.length; j++) {
                expected[k] += weights[j] * slopes[j][k];
                added[k] += Math.abs(weights[j] * slopes[j][k]);
            }
        }
        return EntryComparison.of(expected, start, start, added, found);
    }
}
