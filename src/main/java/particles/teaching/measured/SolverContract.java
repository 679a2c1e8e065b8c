package particles.teaching.measured;

import deSolvers.DESolver;
import deSolvers.FixedStepSolver;
import deSolvers.problems.Oscillator;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.teaching.Finding;
import particles.teaching.GuardedRun.EndlessLoop;
import particles.teaching.StudentFailure;
import particles.teaching.sources.Falling;
import particles.teaching.sources.Probe;
import particles.teaching.sources.Springs;
import particles.teaching.sources.StudentSource;
import particles.teaching.sources.WindyOscillators;

/**
 * Checks the rules that hold for every solver, whatever its formula.
 *
 * @param maker makes a new solver
 */
public record SolverContract(Supplier<DESolver> maker) {
    private static final double H = 1.0 / 16;
    private static final int REPEATED = 6;
    private static final int SIZE = 12;
    private static final int MANY = 40;
    /** So small that an adaptive method accepts its first step. */
    private static final double TINY = StrictMath.pow(2, -40);
    private static final double SAME = 1e-6;
    private static final double ROUNDING = 1e-12;
    private static final double START = 0.5;
    /** There a method that loses an order is off by a hundred times its error, and right ones by at most 3 times. */
    private static final double SHORT = H / 8;
    private static final double ASTRAY = 20;
    private static final double TOLERATED = 1e-8;
    /** The last one is no power of 2, so that a clock in float arithmetic shows. */
    private static final double[] LENGTHS = {1.0 / 32, 0.25, 0.1};

    private StudentSource after(StudentSource source, double deltaT) {
        return StudentSource.after(source, maker.get(), 1, deltaT);
    }

    /** @return why it makes no step, or not the same one each time */
    public Optional<Finding> start() {
        StudentSource source = after(new WindyOscillators(2), H);
        double[] end = source.getState();
        boolean written = source.getEvaluations() > 1 || !(maker.get() instanceof FixedStepSolver) && (source.isSet()
                || source.times() > 0);
        boolean stays = Arrays.equals(new WindyOscillators(2).getState(), end);
        return Phrase.NOTHING_YET.when(!written && stays).or(() -> Phrase.NO_DERIVATIVE.when(source.getEvaluations()
                == 0)).or(() -> Phrase.NEVER_SET.when(!source.isSet())).or(() -> Phrase.NOT_FINITE.when(
                !Double.isFinite(Arrays.stream(end).sum()))).or(() -> Phrase.NOT_REPEATABLE.when(!Arrays.equals(steps(
                false), steps(true))));
    }

    /** The state after some steps, between which another solver may step another source. */
    private double[] steps(boolean beside) {
        WindyOscillators source = new WindyOscillators(2);
        WindyOscillators other = new WindyOscillators(2).from(START);
        DESolver solver = maker.get();
        DESolver second = maker.get();
        for (int step = 0; step < REPEATED; step++) {
            source.step(solver, H);
            if (beside) {
                other.step(second, H);
            }
        }
        return source.getState();
    }

    /** @return the mistake of a clock that does not end where the step does, in one of several steps */
    public Optional<Finding> clock() {
        return Arrays.stream(LENGTHS).boxed().flatMap(h -> Stream.of(new WindyOscillators(1).from(START), new Falling(
                0)).flatMap(source -> {
                    DESolver solver = maker.get();
                    return IntStream.rangeClosed(1, REPEATED).mapToObj(step -> {
                        double before = source.getTime();
                        source.step(solver, h);
                        double off = source.getTime() - before - h;
                        return Phrase.CLOCK.when(Math.abs(off) > ROUNDING * h, step, h, (float) off);
                    }).flatMap(Optional::stream);
                })).findFirst();
    }

    /** @return an entry of the new state that changes with another one's state or derivative, or with nothing */
    public Optional<Finding> entries() {
        double[] numbers = new Random(9).doubles(SIZE, TINY, 2 * TINY).toArray();
        double[] usual = stepWith(numbers).getState();
        double[] nothing = after(new Falling(0), H).getState();
        return IntStream.range(0, SIZE).boxed().flatMap(j -> {
            double[] changed = numbers.clone();
            changed[j] *= -2;
            double[] other = stepWith(changed).getState();      // a velocity moves its position, too
            return IntStream.range(0, SIZE).filter(k -> k != j && (k != j - 3 || k % 6 > 2) && Math.abs(other[k]
                    - usual[k]) > SAME * TINY).mapToObj(k -> Phrase.LAYOUT.of(k, j));
        }).findFirst().or(() -> IntStream.range(0, SIZE).filter(k -> Math.abs(nothing[k]) > SAME).mapToObj(k ->
                Phrase.ADDS.of(k, nothing[k])).findFirst());
    }

    /** A source after a step from these numbers, which are the derivatives, too, and never change. */
    private Probe stepWith(double[] numbers) {
        Probe probe = new Probe(numbers, START, evaluation -> numbers);
        probe.step(maker.get(), H);
        return probe;
    }

    /** @return the mistake if many equal particles do not move alike */
    public Optional<Finding> alike() {
        WindyOscillators source = WindyOscillators.apart(MANY).from(START);
        try {
            after(source, H);
        } catch (IndexOutOfBoundsException | IllegalArgumentException e) {
            return Optional.of(Phrase.ALIKE.of(MANY, StudentFailure.describe(e)));
        }
        double[] end = source.getState();
        return IntStream.range(0, end.length).filter(k -> !(Math.abs(end[k] - end[k % 6]) <= SAME)).mapToObj(k ->
                Phrase.ALIKE.of(MANY, "entry " + k + " is " + end[k] + " and entry " + k % 6 + " is " + end[k % 6]))
                .findFirst();
    }

    /** @return the number of evaluations in a step of a nonlinear particle; -1 if it is too long for the solver */
    public long evaluations(double deltaT) {
        StudentSource source = new WindyOscillators(1);
        return source.accepts(maker.get(), deltaT) ? source.getEvaluations() : -1;
    }

    /** @return mistakes and notes on steps back, other sources, and sources that fail */
    public List<Finding> conduct() {
        return Stream.of(back(), line(), failing(), notANumber()).flatMap(Optional::stream).toList();
    }

    /** Judges a step back after one forward, which leads about as far off as that step's error. */
    private Optional<Finding> back() {
        WindyOscillators source = new WindyOscillators(1).from(START);
        double[] start = source.getState();
        double error = after(source, SHORT).error();
        double[] there = source.getState();
        if (!source.accepts(maker.get(), -SHORT)) {
            return Optional.empty();
        }
        double clock = source.getTime() - START;
        double off = StudentSource.distance(start, source.getState());
        return Phrase.NOTHING_BACK.when(Arrays.equals(there, source.getState())).or(() -> Phrase.BACK.when(!(off
                <= TOLERATED + ASTRAY * error) || Math.abs(clock) > ROUNDING, SHORT, off, clock, error));
    }

    /** A note on a solver that steps no source of two numbers. */
    private Optional<Finding> line() {
        Oscillator line = new Oscillator();
        double[] space = after(new Springs(), H).getState();
        double[] two = new double[2];
        try {
            line.step(maker.get(), H);
            line.getState(two);
        } catch (RuntimeException e) {
            return Optional.of(Phrase.ONLY_PARTICLES.of(StudentFailure.describe(e)));
        }
        return Phrase.ONLY_PARTICLES.when(!(StudentSource.distance(two, new double[] {space[0], space[3]}) <= SAME),
                "it leaves " + two[0] + ", " + two[1] + " where a particle in space has " + space[0] + ", " + space[3]);
    }

    /** NaN may be refused, and stays otherwise: it is not taken for a number, and no step waits for its end. */
    private Optional<Finding> notANumber() {
        StudentSource source = new Falling(Double.NaN);
        try {
            return Phrase.NAN.when(source.accepts(maker.get(), H) && Double.isFinite(source.getState()[SIZE - 1]),
                    "the new state is a number");
        } catch (EndlessLoop e) {
            return Phrase.NAN.when(true, "the step does not come back");
        }
    }

    /** A source that fails has to be heard of. */
    private Optional<Finding> failing() {
        Probe probe = new Probe(new double[SIZE], START, evaluation -> {
            throw new IllegalStateException("the source fails, as it was told to");
        });
        return Phrase.SWALLOWS.when(probe.accepts(maker.get(), H));
    }
}
