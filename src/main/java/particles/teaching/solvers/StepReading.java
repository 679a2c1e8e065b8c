package particles.teaching.solvers;

import deSolvers.DESolver;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.teaching.Finding;
import particles.teaching.Formula;
import particles.teaching.contract.Phrase;
import particles.teaching.contract.SolverContract;
import particles.teaching.sources.Probe;

/**
 * One step of a solver, read as a linear combination of the old state and the derivatives that it asked for.
 *
 * <p>The step is made on a {@link Probe} with random numbers for the old state and the derivatives, and again with one
 * of them changed: what changes in a state is the weight of that number in it. Steps with other numbers tell whether
 * the weights say all. First all derivatives are independent, as for a method that treats all entries alike. If that is
 * not all, the derivative of a position is the velocity, and the numbers are positions, velocities and accelerations.
 *
 * @param scheme   the rows and times of the last step
 * @param h        the length of the step (s)
 * @param steps    the number of steps that were made; the last one is read
 * @param calls    the probe of one of the runs, which has the times and the calls
 * @param before   the row of the state before the last step
 * @param findings what was found on the way: entries left out, digits lost, derivatives cut off
 */
record StepReading(Scheme scheme, double h, int steps, Probe calls, double[] before, List<Finding> findings) {
    /** The clock at the start (s). */
    static final double START = 2;
    /** Unusually large derivatives, to detect a solver that limits them. */
    private static final double LARGE = 1e3;
    /** Unusually small ones, to detect a solver that rounds to 0; an iteration to 1e-10 is exact to 1e-6 of them. */
    private static final double SMALL = 1e-4;
    private static final int SIZE = 24;
    private static final int FEW = 6;
    /** Runs that test the weights. */
    private static final int MORE = 8;
    /** Measured: 3e-15 for RK4, 3e-13 for Yoshida's method; float arithmetic leaves 1e-7. */
    private static final double DOUBLE_ROUNDING = 1e-11;
    /** Below this it may be float arithmetic, or numbers that are rounded to a few decimals. */
    private static final double ROUNDED = 1e-3;

    /**
     * A run with given numbers.
     *
     * @param numbers for each weight the numbers that it multiplies in the entries: the state at the start, then the
     *                derivatives; or positions, velocities, then accelerations, the same for a position
     *                and its velocity
     * @param states  the states at the evaluations, then that before the last step, then the new one
     */
    private record Run(double[][] numbers, Probe probe, List<double[]> states) {
        /** @return the same numbers, with some added to those of a weight */
        double[][] changed(int column, double by) {
            double[][] changed = numbers.clone();
            changed[column] = Arrays.stream(numbers[column]).map(x -> x + by).toArray();
            return changed;
        }

        /** @return the largest part of a state that the weights do not say, in units of the numbers' size */
        double misfit(double[][][] weights, double size) {
            return IntStream.range(0, weights.length).mapToDouble(i -> SolverContract.distance(states.get(i),
                    IntStream.range(0, SIZE).mapToDouble(k -> IntStream.range(0, weights[i][k].length).mapToDouble(c ->
                    weights[i][k][c] * numbers[c][k]).sum()).toArray())).reduce(0, Math::max) / size;
        }
    }

    /**
     * @param size    the size of the derivatives: 1, or so small that an adaptive method accepts its first step
     * @param steps   the number of steps that are made; the last one is read
     * @param most    the largest number of evaluations in a step
     * @param byClock whether the derivative depends on the clock alone, so that iterations for stages end; the last
     *                evaluation at each clock is read, in the order in which the clocks are first seen
     * @return the reading; empty if a step is not a combination with fixed weights
     */
    static Optional<StepReading> of(Supplier<DESolver> maker, double h, double size, int steps, int most,
            boolean byClock) {
        for (boolean particles : new boolean[] {false, true}) {
            try {
                return Optional.of(new Reader(maker, h, size, steps, most, particles, byClock, new ArrayList<>())
                        .read());
            } catch (RuntimeException e) {
                continue;                               // with velocities, adaptive or implicit
            }
        }
        return Optional.empty();
    }

    /** Reads a step, of all entries alike or of positions and velocities; throws an exception if that is not all. */
    private record Reader(Supplier<DESolver> maker, double h, double size, int steps, int most, boolean particles,
            boolean byClock, List<Finding> findings) {
        private int first() {
            return particles ? 2 : 1;
        }

        private double[][] numbers(Random random, double largest) {
            double[][] numbers = new double[2 + most * steps][];
            Arrays.setAll(numbers, c -> {
                double least = c < first() ? Math.min(1, largest) : -largest;
                double[] row = random.doubles(SIZE, least, c < first() ? 2 * least : largest).toArray();
                return IntStream.range(0, SIZE).mapToDouble(k -> particles ? row[k - k % 6 + 3 + k % 3] : row[k])
                        .toArray();
            });
            return numbers;
        }

        private Run run(double[][] numbers) {
            double[] before = numbers[0].clone();
            Arrays.setAll(before, k -> numbers[particles && k % 6 > 2 ? 1 : 0][k]);
            Probe probe = new Probe.OfParticles(before, START, (j, dSdt) -> System.arraycopy(numbers[first() + j], 0,
                    dSdt, 0, SIZE), numbers.length - first(), particles, byClock);
            DESolver solver = maker.get();
            for (int step = 0; step < steps; step++) {
                before = probe.getState();
                probe.step(solver, h);
            }
            return new Run(numbers, probe, Stream.concat(probe.recorded().stream().map(Probe.Evaluation::state),
                    Stream.of(before, probe.getState())).toList());
        }

        /** Another run, which has to be as long. */
        private Run again(Run one, double[][] numbers) {
            Run other = run(numbers);
            if (other.states.size() != one.states.size()) {
                throw new IllegalStateException("the number of evaluations depends on the numbers");
            }
            return other;
        }

        StepReading read() {
            Random random = new Random(715);
            Run run = run(numbers(random, size));
            int n = run.states.size() - 2;
            double[][][] weights = new double[n + 2][SIZE][n + first()];
            for (int c = 0; c < n + first(); c++) {
                Run other = again(run, run.changed(c, size));
                for (int i = 0; i < n + 2; i++) {
                    for (int k = 0; k < SIZE; k++) {
                        weights[i][k][c] = (other.states.get(i)[k] - run.states.get(i)[k]) / size;
                    }
                }
            }
            double[] off = Stream.concat(Stream.generate(() -> size).limit(MORE), Stream.of(LARGE, SMALL).filter(one ->
                    size == 1 && !byClock)).mapToDouble(one -> again(run, numbers(random, one)).misfit(weights, one))
                    .toArray();
            double rounded = Arrays.stream(off).limit(MORE).reduce(0, Math::max);       // NaN stays
            if (!(rounded <= ROUNDED)) {
                throw new IllegalStateException("the weights do not describe the step");
            }
            List<double[]> rows = new ArrayList<>();
            double[] velocity = {};
            for (int i = 0; i < n + 2; i++) {
                velocity = particles ? row(i, 1, rounded, weights[i]) : velocity;
                rows.add(row(i, 0, rounded, weights[i]));
            }
            double[] before = rows.remove(n);
            if (particles) {
                rows.add(velocity);
                boolean still = sum(velocity, 2) == 0;
                if (run.probe.isSet() && still != (sum(rows.get(n), 1) == 0)) {
                    leaveOut(entries(still ? 1 : 0), n + 1, n);
                }
            }
            Phrase.DIGITS.when(rounded > DOUBLE_ROUNDING, rounded).ifPresent(findings::add);
            IntStream.range(MORE, off.length).filter(j -> !(off[j] <= ROUNDED)).limit(1).forEach(j -> findings.add(
                    Phrase.CUT_OFF.of(j == MORE ? LARGE : SMALL)));
            double[] times = run.probe.recorded().stream().mapToDouble(at -> (at.time() - START) / h - (steps - 1))
                    .map(at -> byClock ? Math.rint(at * 1e9) / 1e9 : at).toArray();
            return new StepReading(new Scheme("", 0, rows, times, particles), h, steps, run.probe, before, findings);
        }

        /** The weights that most entries have, in units of powers of deltaT. */
        private double[] row(int i, int kind, double rounded, double[][] weights) {
            for (double[] entry : weights) {
                Arrays.setAll(entry, c -> Math.abs(entry[c]) < DOUBLE_ROUNDING + MORE * rounded ? 0 : entry[c]);
            }
            List<Integer> same = entries(kind);             // by the clock, some entries are moved for differences
            double[] row = same.stream().map(k -> weights[k]).sorted(Comparator.comparingDouble(one -> sum(one, 1)))
                    .skip(byClock ? same.size() / 2 : same.size() - 1).findFirst().orElseThrow();
            if (same.stream().anyMatch(k -> !stays(weights[k], row) && !(SolverContract.distance(weights[k], row)
                    <= ROUNDED + MORE * MORE * rounded))) {
                throw new IllegalStateException("each entry has other weights");
            }
            leaveOut(same.stream().filter(k -> stays(weights[k], row)).toList(), i, row.length - first());
            double[] inSteps = row.clone();
            Arrays.setAll(inSteps, c -> row[c] / StrictMath.pow(h, Math.min(c, first()) - kind));
            if (sum(inSteps, 1) > LARGE) {
                throw new IllegalStateException("these are difference quotients");
            }
            return inSteps;
        }

        /** The positions, 0, or velocities, 1; all entries if they are treated alike. */
        private List<Integer> entries(int kind) {
            return IntStream.range(0, SIZE).filter(k -> !particles || k % 6 / 3 == kind).boxed().toList();
        }

        private void leaveOut(List<Integer> entries, int i, int n) {
            if (findings.isEmpty() && !entries.isEmpty()) {
                String some = entries.stream().limit(FEW).map(String::valueOf).collect(Collectors.joining(", "));
                findings.add(Phrase.LEFT_OUT.of(i > n ? "the new state" : "the trial state at evaluation " + (i + 1),
                        entries.size() > FEW ? some + "..." : some, SIZE));
            }
        }
    }

    private static double sum(double[] row, int from) {
        return Arrays.stream(row).skip(from).map(Math::abs).sum();
    }

    /** Whether an entry is not moved, or not by the derivatives, though others are. */
    private static boolean stays(double[] row, double[] other) {
        return IntStream.rangeClosed(1, 3).anyMatch(from -> sum(row, from) == 0 && sum(other, from) != 0);
    }

    int evaluations() {
        return scheme.size();
    }

    /** @return how far one of its states moves, in units of deltaT */
    double moves(int r) {
        return scheme.states().get(r).moves();
    }

    /** @return whether the clock ends where the step does */
    boolean isOnTime() {
        return Formula.sameTime((calls.getTime() - START) / h - steps, 0);
    }

    /** @return whether the state is evaluated and stays where it was */
    boolean isStill() {
        return evaluations() > 0 && calls.isSet() && scheme.rows().stream().skip(evaluations()).allMatch(row ->
                Formula.same(sum(row, 0), 1));
    }
}
