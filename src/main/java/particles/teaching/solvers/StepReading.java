package particles.teaching.solvers;

import deSolvers.DESolver;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.function.DoubleFunction;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.teaching.Finding;
import particles.teaching.Formula;
import particles.teaching.contract.SolverContract;
import particles.teaching.sources.Probe;

/**
 * One step of a solver, read as a linear combination of the old state and the derivatives that it asked for.
 *
 * <p>The step is made again and again on {@link Probe}s with random states and derivatives; least squares give the
 * weights in the new state and in the state of each evaluation, and tell whether they say all. First all derivatives
 * are independent, as for a method that treats all entries alike; a row of weights is that of s and those of the
 * derivatives, in units of deltaT. If that is not all, the derivative of a position is the velocity; a row of a
 * position has the weights of x, of v deltaT, and those of the accelerations in units of deltaT^2.
 *
 * @param isOfParticles whether positions and velocities are treated in another way
 * @param h             the length of the step (s)
 * @param steps         the number of steps that were made; the last one is read
 * @param calls         the probe of one of the runs, which has the times and the calls
 * @param rows          the rows of the state, or of a position: for each evaluation, for the state before the last
 *                      step, for the new state; at last, of particles, the row of the new velocity
 * @param findings      what was found on the way: entries left out, digits lost, derivatives cut off
 */
record StepReading(boolean isOfParticles, double h, int steps, Probe calls, double[][] rows, List<Finding> findings) {
    /** The clock at the start (s). */
    static final double START = 2;
    /** So small that an adaptive method accepts its first step. */
    static final double TINY = StrictMath.pow(2, -40);
    /** Unusually large derivatives, to detect a solver that limits them. */
    private static final double LARGE = 1e3;
    /** Unusually small ones, to detect a solver that rounds to 0; an iteration to 1e-10 is exact to 1e-6 of them. */
    private static final double SMALL = 1e-4;
    private static final int SIZE = 24;
    private static final int FEW = 6;
    /** More runs than there are weights. */
    private static final int MORE = 8;
    /** Measured: 3e-15 for RK4, 3e-13 for Yoshida's method; float arithmetic leaves 1e-7. */
    private static final double DOUBLE_ROUNDING = 1e-11;
    /** Below this it may be float arithmetic, or numbers that are rounded to a few decimals. */
    private static final double ROUNDED = 1e-3;

    /**
     * A run with random numbers.
     *
     * @param slopes the state at the start, then the derivatives
     * @param before the state before its last step
     */
    private record Run(double[][] slopes, Probe probe, double[] before) {
        /** @return the state at an evaluation, then that before the last step, then the new state */
        double[] state(int i) {
            int n = probe.recorded().size();
            return i < n ? probe.recorded().get(i).state() : i == n ? before : probe.getState();
        }
    }

    /**
     * @param size  the size of the derivatives: 1, or so small that an adaptive method accepts its first step
     * @param steps the number of steps that are made; the last one is read
     * @return the reading; empty if a step is not a combination with fixed weights
     */
    static Optional<StepReading> of(Supplier<DESolver> maker, double h, double size, int steps) {
        for (boolean particles : new boolean[] {false, true}) {
            try {
                Random random = new Random(715);
                return Optional.of(read(particles, h, size, steps, most -> run(maker, h, steps, particles,
                        slopes(random, most, steps))));
            } catch (RuntimeException e) {
                continue;                               // with velocities, adaptive or implicit
            }
        }
        return Optional.empty();
    }

    /** The state at the start, then the derivatives. */
    private static double[][] slopes(Random random, double size, int steps) {
        double[][] slopes = new double[1 + Probe.MOST_EVALUATIONS * steps][];
        Arrays.setAll(slopes, j -> random.doubles(SIZE, j == 0 ? Math.min(1, size) : -size, j == 0 ? 2 * Math.min(1,
                size) : size).toArray());
        return slopes;
    }

    private static Run run(Supplier<DESolver> maker, double h, int steps, boolean particles, double[][] slopes) {
        Probe probe = new Probe.OfParticles(slopes[0], START, (j, dSdt) -> System.arraycopy(slopes[1 + j], 0, dSdt, 0,
                SIZE), slopes.length - 1, particles);
        DESolver solver = maker.get();
        double[] before = slopes[0];
        for (int step = 0; step < steps; step++) {
            before = probe.getState();
            solver.stepState(probe, h);
        }
        return new Run(slopes, probe, before);
    }

    private static StepReading read(boolean particles, double h, double size, int steps, DoubleFunction<Run> runner) {
        Run first = runner.apply(size);
        int n = first.probe.recorded().size();
        List<Run> runs = Stream.generate(() -> runner.apply(size)).limit(n + MORE).toList();
        List<Run> large = size == 1 ? List.of(runner.apply(LARGE)) : List.of();
        List<Run> small = size == 1 ? List.of(runner.apply(SMALL)) : List.of();
        if (Stream.of(runs, large, small).flatMap(List::stream).anyMatch(run -> run.probe.recorded().size() != n)) {
            throw new IllegalStateException("the number of evaluations depends on the numbers");
        }
        double[][][] all = new double[n + 2][SIZE][];
        double rounded = 0;
        double cut = 0;
        double lost = 0;
        for (int k = 0; k < SIZE; k++) {
            double[][] columns = columns(runs, k, particles, n);
            double[][] states = states(runs, k, n);
            double[][] found = LeastSquares.weights(columns, states);
            for (int i = 0; i < n + 2; i++) {
                rounded = Math.max(rounded, LeastSquares.misfit(columns, found[i], states[i]) / size);
                cut = Math.max(cut, LeastSquares.misfit(columns(large, k, particles, n), found[i], states(large, k,
                        n)[i]) / LARGE);
                lost = Math.max(lost, LeastSquares.misfit(columns(small, k, particles, n), found[i], states(small, k,
                        n)[i]) / SMALL);
                all[i][k] = found[i];
            }
        }
        double nothing = DOUBLE_ROUNDING + MORE * rounded;
        Stream.of(all).flatMap(Stream::of).forEach(row -> Arrays.setAll(row, c -> Math.abs(row[c]) < nothing ? 0
                : row[c] / (c == 0 ? 1 : c == 1 || row.length == n + 1 ? h : h * h)));
        List<Finding> findings = new ArrayList<>();
        double many = MORE * MORE * rounded / Math.abs(h);
        double[][] rows = new double[particles ? n + 3 : n + 2][];
        for (int i = 0; i < n + 2; i++) {
            double[][] entries = all[i];
            for (int kind = particles ? 1 : 0; kind >= 0; kind--) {
                List<Integer> same = entries(kind, particles);
                double[] row = same.stream().map(k -> entries[k]).max(Comparator.comparingDouble(one -> sum(one, 1)))
                        .orElseThrow();
                rows[i + kind] = row;
                if (same.stream().anyMatch(k -> !stays(entries[k], row) && !(SolverContract.distance(entries[k], row)
                        <= ROUNDED + many))) {
                    throw new IllegalStateException("each entry has other weights");
                }
                leaveOut(findings, same.stream().filter(k -> stays(entries[k], row)).toList(), i, n);
            }
        }
        boolean still = sum(rows[rows.length - 1], 1) == 0;
        if (particles && first.probe.everSet() && still != (sum(rows[n + 1], 1) == 0)) {
            leaveOut(findings, entries(still ? 1 : 0, true), n + 1, n);
        }
        if (!(rounded <= ROUNDED) || Stream.of(rows).anyMatch(row -> sum(row, 1) > LARGE)) {
            throw new IllegalStateException("the weights do not describe the step, or are difference quotients");
        }
        if (rounded > DOUBLE_ROUNDING) {
            findings.add(Phrase.DIGITS.of(rounded));
        }
        if (!(Math.max(cut, lost) <= ROUNDED)) {
            findings.add(Phrase.CUT_OFF.of(cut > ROUNDED ? LARGE : SMALL));
        }
        return new StepReading(particles, h, steps, first.probe, rows, findings);
    }

    /** For each weight of an entry, the numbers that it multiplies in all runs. */
    private static double[][] columns(List<Run> runs, int k, boolean particles, int n) {
        boolean position = particles && k % 6 < 3;
        Stream<double[]> own = IntStream.rangeClosed(0, n).mapToObj(j -> runs.stream().mapToDouble(run ->
                run.slopes[j][position ? k + 3 : k]).toArray());
        return (position ? Stream.concat(Stream.of(runs.stream().mapToDouble(run -> run.slopes[0][k]).toArray()), own)
                : own).toArray(double[][]::new);
    }

    /** An entry in all runs, for each of the states. */
    private static double[][] states(List<Run> runs, int k, int n) {
        return IntStream.range(0, n + 2).mapToObj(i -> runs
                .stream().mapToDouble(run -> run.state(i)[k]).toArray()).toArray(double[][]::new);
    }

    /** The positions, 0, or velocities, 1; all entries if they are treated alike. */
    private static List<Integer> entries(int kind, boolean particles) {
        return IntStream.range(0, SIZE).filter(k -> !particles || k % 6 / 3 == kind).boxed().toList();
    }

    private static double sum(double[] row, int from) {
        return Arrays.stream(row, from, row.length).map(Math::abs).sum();
    }

    /** Whether an entry is not moved, or not by the derivatives, though others are. */
    private static boolean stays(double[] row, double[] other) {
        return IntStream.of(1, 2).anyMatch(from -> row.length > from && sum(row, from) == 0 && sum(other, from) != 0);
    }

    private static void leaveOut(List<Finding> findings, List<Integer> entries, int i, int n) {
        if (findings.isEmpty() && !entries.isEmpty()) {
            String some = entries.stream().limit(FEW).map(String::valueOf).collect(Collectors.joining(", "));
            findings.add(Phrase.LEFT_OUT.of(i > n ? "the new state" : "the trial state at evaluation " + (i + 1),
                    entries.size() > FEW ? some + "..." : some, SIZE));
        }
    }

    int evaluations() {
        return calls.recorded().size();
    }

    /** @return the clock at an evaluation since the start, in units of deltaT */
    double clock(int i) {
        return (calls.recorded().get(i).time() - START) / h - (steps - 1);
    }

    /** @return whether the clock ends where the step does */
    boolean isOnTime() {
        return Formula.sameTime((calls.getTime() - START) / h - steps, 0);
    }

    /** @return the sum of the weights of the derivatives in the new state, or in the new velocity */
    double increment() {
        return increment(rows.length - 1);
    }

    double increment(int row) {
        return Arrays.stream(rows[row]).skip(1).sum();
    }

    /** @return how far the velocity moves a position, in units of deltaT */
    double moved() {
        return rows[evaluations() + 1][1];
    }

    /** @return whether the state is evaluated and stays where it was */
    boolean isStill() {
        return evaluations() > 0 && calls.everSet() && Arrays.stream(rows).skip(evaluations() + 1).allMatch(row -> sum(
                row, 1) == 0);
    }
}
