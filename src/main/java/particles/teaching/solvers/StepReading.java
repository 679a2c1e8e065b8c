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
import particles.teaching.Finding;
import particles.teaching.sources.Probe;

/**
 * One step of a solver, read as a linear combination of the old state and the derivatives that it asked for.
 *
 * <p>The step is made again and again on {@link Probe}s that differ in one of these alone: the change is the weight of
 * that one, in the new state and in the state of each evaluation. A row of weights has first those of the
 * entry's own old value and of its partner's (the velocity of a position), then those of its own derivatives, then
 * those of the partner's. A last step with random numbers shows whether the rows say all.
 */
final class StepReading {
    static final int OWN = 0;
    static final int PARTNER = 1;
    /** The clock at the start (s). */
    static final double START = 2;
    /** So small that an adaptive method accepts its first step. */
    static final double TINY = StrictMath.pow(2, -40);
    /** Unusually large derivatives, to detect a solver that limits them. */
    private static final double LARGE = 1e3;
    private static final int SIZE = 24;
    private static final int FEW = 6;
    /** A few roundings of double arithmetic; measured 3e-16 for RK4, 4e-13 for Yoshida's method. */
    private static final double DOUBLE_ROUNDING = 1e-12;
    /** Below this it may be float arithmetic, with roundings of 6e-8, or numbers that are rounded to a few decimals. */
    private static final double ROUNDED = 1e-3;

    /** What is left of a weight of 0 after two subtractions. */
    private static final double NOTHING = 1e-13;

    private final Supplier<DESolver> maker;
    private final double h;
    private final double size;
    private final boolean alike;
    private final int steps;
    private final Probe base;
    private final double[][] x;
    private final double[][] v;
    private final List<Finding> findings = new ArrayList<>();

    private StepReading(Supplier<DESolver> maker, double h, double size, boolean alike, int steps) {
        this.maker = maker;
        this.h = h;
        this.size = size;
        this.alike = alike;
        this.steps = steps;
        Random random = new Random(715);
        double[] start = random.doubles(SIZE, size, 2 * size).toArray();
        double[][] slopes = slopes(random, size);
        Run plain = run(start, (j, dSdt) -> System.arraycopy(slopes[j], 0, dSdt, 0, SIZE));
        base = plain.probe;
        int n = evaluations();
        double[][][] rows = new double[n + 2][SIZE][2 + 2 * n];
        for (int e = 0; e < 2 + 2 * n; e++) {
            boolean velocity = e == PARTNER || e >= 2 + n;
            double[] more = new double[SIZE];
            Arrays.setAll(more, k -> k % 6 > 2 == velocity ? size : 0);
            int number = e < 2 ? -1 : (e - 2) % n;
            Run run = run(e < 2 ? Combination.plus(start, 1, more) : start, (j, dSdt) -> System.arraycopy(
                    j == number ? Combination.plus(slopes[j], 1, more) : slopes[j], 0, dSdt, 0, SIZE));
            if (run.probe.recorded().size() != n) {
                throw new IllegalStateException("the number of evaluations depends on the numbers");
            }
            for (int i = 0; i < n + 2; i++) {
                double[] difference = Combination.plus(run.state(i), -1, plain.state(i));
                for (int k = 0; k < SIZE; k++) {
                    int column = k % 6 < 3 ? e : e < 2 ? 1 - e : velocity ? e - n : e + n;
                    double weight = difference[k] / size;
                    rows[i][k][column] = Math.abs(weight) < NOTHING ? 0 : weight;
                }
            }
        }
        x = Arrays.stream(rows).map(row -> largest(row, 0)).toArray(double[][]::new);
        v = Arrays.stream(rows).map(row -> largest(row, 3)).toArray(double[][]::new);
        compare();
    }

    /** A run, and the state before its last step. */
    private record Run(Probe probe, double[] before, double time) {
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
        Optional<StepReading> found = Optional.empty();
        for (boolean alike : new boolean[] {false, true}) {
            try {
                found = Optional.of(new StepReading(maker, h, size, alike, steps));
                if (found.get().isOneFormula()) {
                    return found;
                }
            } catch (RuntimeException e) {
                continue;                               // adaptive, implicit, or with an iteration for the velocity
            }
        }
        return found;
    }

    private Run run(double[] start, Probe.Answer answer) {
        Probe probe = new Probe.OfParticles(start, START, answer, Probe.MOST_EVALUATIONS * steps, alike);
        DESolver solver = maker.get();
        double[] before = start;
        double time = START;
        for (int step = 0; step < steps; step++) {
            before = probe.getState();
            time = probe.getTime();
            solver.stepState(probe, h);
        }
        return new Run(probe, before, time);
    }

    /** The row with most of the derivatives, among the entries of one kind; others may be left out by mistake. */
    private static double[] largest(double[][] rows, int first) {
        return IntStream.range(0, SIZE).filter(k -> k % 6 / 3 == first / 3).mapToObj(k -> rows[k]).max(
                Comparator.comparingDouble(StepReading::all)).orElseThrow();
    }

    private static double all(double[] row) {
        return Arrays.stream(row, 2, row.length).map(Math::abs).sum();
    }

    /** @return the sum of the weights of an entry's own derivatives */
    static double derivatives(double[] row) {
        return Arrays.stream(row, 2, 1 + row.length / 2).sum();
    }

    /** @return how far the velocity, old or as a derivative, moves a position (s) */
    double moved() {
        return newPosition()[PARTNER] + derivatives(newPosition());
    }

    /** Makes steps with numbers that use all digits of a double, and compares all states with those by the rows. */
    private void compare() {
        double rounded = misfit(size);
        boolean still = all(newVelocity()) == 0;
        if (findings.isEmpty() && base.everSet() && still != (all(newPosition()) + newPosition()[PARTNER] == 0)) {
            leaveOut(IntStream.range(0, SIZE).filter(k -> k % 6 > 2 == still).boxed().toList(), evaluations() + 1);
        }
        if (!(rounded <= ROUNDED)) {
            throw new IllegalStateException("the weights do not describe the step");
        }
        if (rounded > DOUBLE_ROUNDING) {
            findings.add(Phrase.DIGITS.of(rounded, rounded < 1e-6
                    ? "in float arithmetic; all numbers have to be double"
                    : "if a number were rounded on the way; only what is printed may be"));
        }
        if (size == 1 && !(misfit(LARGE) <= ROUNDED)) {
            findings.add(Phrase.CUT_OFF.of(LARGE));
        }
    }

    /** Notes the entries that stay, in the state of an evaluation or in the new one; once. */
    private void leaveOut(List<Integer> entries, int i) {
        if (findings.isEmpty() && !entries.isEmpty()) {
            String some = entries.stream().limit(FEW).map(String::valueOf).collect(Collectors.joining(", "));
            findings.add(Phrase.LEFT_OUT.of(i > evaluations() ? "the new state" : "the trial state at evaluation "
                    + (i + 1), entries.size() > FEW ? some + "..." : some, SIZE));
        }
    }

    /** @return the largest difference, relative to the numbers that are added; NaN for other evaluations */
    private double misfit(double most) {
        Random random = new Random(2003);
        double[] start = random.doubles(SIZE, 1, 2).map(value -> value * Math.min(1, most)).toArray();
        double[][] slopes = slopes(random, most);
        Run run = run(start, (j, dSdt) -> System.arraycopy(slopes[j], 0, dSdt, 0, SIZE));
        int n = evaluations();
        if (run.probe.recorded().size() != n) {
            throw new IllegalStateException("more evaluations where more is to be done");
        }
        double largest = 0;
        for (int i = 0; i < n + 2; i++) {
            double[] found = run.state(i);
            List<Integer> left = new ArrayList<>();
            for (int k = 0; k < SIZE; k++) {
                double[] row = k % 6 < 3 ? x[i] : v[i];
                int other = k % 6 < 3 ? k + 3 : k - 3;
                double old = row[OWN] * start[k] + row[PARTNER] * start[other];
                double sum = old;
                double added = Math.abs(start[k]);
                for (int j = 0; j < n; j++) {
                    double part = row[2 + j] * slopes[j][k] + row[2 + n + j] * slopes[j][other];
                    sum += part;
                    added += Math.abs(part);
                }
                double off = Math.abs(found[k] - sum) / added;
                if (off > DOUBLE_ROUNDING && (found[k] == start[k] || Math.abs(found[k] - old) < NOTHING * added)) {
                    left.add(k);
                } else {
                    largest = off <= largest ? largest : off;
                }
            }
            leaveOut(left, i);
        }
        return largest;
    }

    private double[][] slopes(Random random, double most) {
        double[][] slopes = new double[Probe.MOST_EVALUATIONS * steps][];
        for (int j = 0; j < slopes.length; j++) {
            slopes[j] = random.doubles(SIZE, -most, most).toArray();
        }
        return slopes;
    }

    /** @return what was found while it was read: entries left out, digits lost, derivatives cut off */
    List<Finding> findings() {
        return findings;
    }

    int evaluations() {
        return base.recorded().size();
    }

    /** @return the probe of one of the steps, which has the times and the calls */
    Probe calls() {
        return base;
    }

    double h() {
        return h;
    }

    /** @return the clock at an evaluation since the start, in units of deltaT */
    double clock(int i) {
        return (base.recorded().get(i).time() - START) / h - (steps - 1);
    }

    /** @return the clock at the end since the start of the last step (s) */
    double end() {
        return base.getTime() - START - (steps - 1) * h;
    }

    /** @return the rows of a position: for each evaluation, for the state before the last step, for the new state */
    double[][] positions() {
        return x;
    }

    /** @return the rows of a velocity, likewise */
    double[][] velocities() {
        return v;
    }

    double[] newPosition() {
        return x[x.length - 1];
    }

    double[] newVelocity() {
        return v[v.length - 1];
    }

    /** @return whether all entries are treated alike, as by a method that knows nothing of particles */
    boolean isOneFormula() {
        int n = evaluations();
        for (int i = 0; i < x.length; i++) {
            if (!Combination.same(x[i], v[i]) || x[i][PARTNER] != 0
                    || Arrays.stream(x[i], 2 + n, 2 + 2 * n).anyMatch(weight -> weight != 0)) {
                return false;
            }
        }
        return true;
    }

    /** @return whether the state is evaluated and stays where it was */
    boolean isStill() {
        return evaluations() > 0 && base.everSet() && derivatives(newPosition()) + all(newVelocity()) == 0;
    }
}
