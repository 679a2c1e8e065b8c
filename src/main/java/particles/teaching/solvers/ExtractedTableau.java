package particles.teaching.solvers;

import deSolvers.DESolver;
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

    int stages() {
        return b.length;
    }

    /**
     * Makes a step with numbers that use all digits of a double, and compares it with the result by these coefficients.
     *
     * @param solver a new solver
     * @param size   the size of the derivatives
     * @return by entry, the difference relative to the numbers that are added; NaN where the solver left the entry as
     * it was
     */
    double[] misfit(DESolver solver, double size) {
        Random random = new Random(2003);
        double[] start = random.doubles(SIZE, 1, 2).toArray();
        double[][] slopes = new double[Probe.MOST_EVALUATIONS][];
        for (int j = 0; j < slopes.length; j++) {
            slopes[j] = random.doubles(SIZE, -size, size).toArray();
        }
        Probe probe = new Probe(start, START, (j, dSdt) -> System.arraycopy(slopes[j], 0, dSdt, 0, SIZE));
        solver.stepState(probe, h);
        double[] found = probe.state();
        double[] misfit = new double[SIZE];
        if (probe.recorded().size() != stages()) {
            Arrays.fill(misfit, 1);
            return misfit;
        }
        for (int k = 0; k < SIZE; k++) {
            double expected = kept * start[k];
            double added = Math.abs(start[k]);
            for (int j = 0; j < stages(); j++) {
                expected += b[j] * slopes[j][k];
                added += Math.abs(b[j] * slopes[j][k]);
            }
            double difference = Math.abs(found[k] - expected) / added;
            misfit[k] = difference > 1e-12 && found[k] == start[k] ? Double.NaN : difference;
        }
        return misfit;
    }
}
