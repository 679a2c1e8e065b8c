package particles.teaching.measured;

import deSolvers.DESolver;
import deSolvers.FixedStepSolver;
import deSolvers.problems.Oscillator;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.function.DoubleFunction;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.teaching.Finding;
import particles.teaching.GuardedRun.EndlessLoop;
import particles.teaching.StudentFailure;
import particles.teaching.sources.Probe;
import particles.teaching.sources.Springs;
import particles.teaching.sources.StiffDecay;
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
    private static final int FEW = 6;
    private static final int LARGEST = 100_000;
    /** So small that an adaptive method accepts its first step. */
    private static final double TINY = StrictMath.pow(2, -40);
    private static final double SAME = 1e-6;
    private static final double ROUNDING = 1e-12;
    /** A tolerance shows in so long a step. */
    private static final double LONG = 1;
    private static final double START = 0.5;
    /** There a method that loses an order is off by a hundred times its error, and right ones by at most 3 times. */
    private static final double SHORT = H / 8;
    private static final double ASTRAY = 20;
    private static final double TOLERATED = 1e-8;
    /** Trial states are 1e-2 apart. */
    private static final double DIFFERENCE = 1e-4;
    private static final int SOME = 40;
    private static final int MANY = 200;

    private StudentSource after(StudentSource source, double deltaT) {
        return StudentSource.after(source, maker.get(), 1, deltaT);
    }

    /** @return why it makes no step, or not the same one each time */
    public Optional<Finding> start() {
        StudentSource source = after(new WindyOscillators(2), H);
        double[] before = new WindyOscillators(2).getState();
        double[] end = source.getState();
        boolean written = source.getEvaluations() > 1 || !(maker.get() instanceof FixedStepSolver) && (source.isSet()
                || source.timeMoves() > 0);
        boolean stays = Arrays.equals(before, end);
        return source.wrongLength().map(length -> Phrase.ARRAY_LENGTH.of(length, end.length)).or(() ->
                Phrase.NOTHING_YET.when(!written && stays)).or(() -> Phrase.NO_DERIVATIVE.when(source.getEvaluations()
                == 0)).or(() -> Phrase.NEVER_SET.when(!source.isSet())).or(() -> Phrase.NOT_FINITE.when(
                !Double.isFinite(Arrays.stream(end).sum()))).or(() -> Phrase.NOT_REPEATABLE.when(!IntStream.range(0,
                REPEATED).allMatch(time -> {
                    StudentSource twin = after(new WindyOscillators(2), H);
                    return Arrays.equals(twin.getState(), end) && twin.getTime() == source.getTime();
                }))).or(this::leftOut);
    }

    /** @return entries that no loop reaches */
    private Optional<Finding> leftOut() {
        double[] numbers = new Random(5).doubles(2 * SIZE, 1, 2).toArray();
        double[] end = stepWith(numbers).getState();
        List<String> still = IntStream.range(0, end.length).filter(k -> end[k] == numbers[k]).mapToObj(String::valueOf)
                .toList();
        return Phrase.LEFT_OUT.when(!still.isEmpty() && still.size() < end.length, still.stream().limit(FEW).collect(
                Collectors.joining(", ")) + (still.size() > FEW ? "..." : ""), end.length);
    }

    /** @return an entry of the new state that changes with another one's state or derivative, or with nothing */
    public Optional<Finding> entries() {
        double[] numbers = new Random(9).doubles(SIZE, TINY, 2 * TINY).toArray();
        double[] usual = stepWith(numbers).getState();
        double[] nothing = stepWith(new double[SIZE]).getState();
        return IntStream.range(0, SIZE).boxed().flatMap(j -> {
            double[] changed = numbers.clone();
            changed[j] *= -2;
            double[] other = stepWith(changed).getState();      // a velocity moves its position, too
            return IntStream.range(0, SIZE).filter(k -> k != j && (k != j - 3 || k % 6 > 2) && Math.abs(other[k]
                    - usual[k]) > SAME * TINY).mapToObj(k -> Phrase.LAYOUT.of(k, j));
        }).findFirst().or(() -> IntStream.range(0, SIZE).filter(k -> Math.abs(nothing[k]) > SAME).mapToObj(k ->
                Phrase.ADDS.of(k, nothing[k])).findFirst());
    }

    /** @return an entry of the new state that depends on the unit of time */
    public Optional<Finding> units() {
        return Units.mistake(maker);
    }

    /** A source after a step from these numbers, which are the derivatives, too, and never change. */
    private Probe stepWith(double[] numbers) {
        Probe probe = new Probe(numbers, START, evaluation -> numbers, LARGEST);
        probe.step(maker.get(), H);
        return probe;
    }

    /** @return the mistake of a method that makes a spring swing otherwise in another entry, or from the other side */
    public Optional<Finding> asymmetric() {
        return Stream.of(0, 3).flatMap(kind -> {        // displaced, or in motion: signs of errors are alike in one
            double[] first = swing(0, kind, 1);
            double other = StudentSource.distance(first, swing(8, kind, 1));
            double mirrored = StudentSource.distance(first, swing(0, kind, -1));
            return Phrase.LARGEST_ERROR.when(other > SAME, LONG, other).or(() -> Phrase.ABSOLUTE_ERROR.when(
                    mirrored > SAME, LONG, mirrored)).stream();
        }).findFirst();
    }

    /** Position and velocity of a spring after a step, times the sign of its start; 0 if the step is refused. */
    private double[] swing(int entry, int kind, double start) {
        Springs source = new Springs(entry + kind, start);
        if (!source.accepts(maker.get(), LONG)) {
            return new double[2];
        }
        double[] end = source.getState();
        return new double[] {start * end[entry], start * end[entry + 3]};
    }

    /** @return the number of evaluations in a step of nonlinear particles; -1 if it is too long for the solver */
    public long evaluations(int particles, double deltaT) {
        StudentSource source = WindyOscillators.nonlinear(particles);
        return source.accepts(maker.get(), deltaT) ? source.getEvaluations() : -1;
    }

    /**
     * @return whether it evaluates the derivative once more for each entry, at states that hardly differ, as for a
     * matrix
     * of differences
     */
    public boolean makesDifferences() {
        StudentSource source = WindyOscillators.nonlinear(1).from(START);
        source.startRecord();
        source.accepts(maker.get(), H);
        List<double[]> at = source.evaluatedAt();
        return evaluations(2, H) >= evaluations(1, H) + FEW && at.stream().anyMatch(one ->
                at.stream().mapToDouble(other -> StudentSource.distance(one, other)).anyMatch(d -> d > 0
                && d < DIFFERENCE));
    }

    /** @return how far a source is from its start after a step of this length and one back; empty if one is refused */
    public Optional<Double> thereAndBack(StudentSource source, double deltaT) {
        double[] start = source.getState();
        return source.accepts(maker.get(), deltaT) && source.accepts(maker.get(), -deltaT)
                ? Optional.of(StudentSource.distance(start, source.getState())) : Optional.empty();
    }

    /** @return mistakes and notes on other sources, other lengths of steps, and sources that fail */
    public List<Finding> conduct() {
        return Stream.of(manyParticles(), back(), moved(new WindyOscillators(1), 0, Phrase.REFUSES_ZERO, moved ->
                Phrase.MOVES_AT_ZERO.when(moved > ROUNDING, moved)), otherSources(), failing(0), failing(1),
                notFinite()).flatMap(Optional::stream).distinct().toList();
    }

    /** Equal particles, many of them, have to move alike. */
    private Optional<Finding> manyParticles() {
        int particles = evaluations(2, H) >= evaluations(1, H) + FEW ? SOME : MANY;
        double[] end;
        try {
            end = after(new WindyOscillators(particles), H).getState();
        } catch (RuntimeException e) {
            return Optional.of(Phrase.SIZE.of(particles, StudentFailure.describe(e)));
        }
        return IntStream.range(0, end.length).filter(k -> !(Math.abs(end[k] - end[k % 6]) <= SAME)).mapToObj(k ->
                Phrase.SIZE.of(particles, "entry " + k + " is " + end[k] + " and entry " + k % 6 + " is " + end[k % 6]))
                .findFirst();
    }

    /** Notes on sources that are no particles in space. */
    private Optional<Finding> otherSources() {
        try {
            after(new StiffDecay(), 0.1 / StiffDecay.RATE);
        } catch (RuntimeException e) {
            return Optional.of(Phrase.FOR_PARTICLES.of());
        }
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

    /** Judges a step back after one forward: clock and state, which is about as far off as that step's error. */
    private Optional<Finding> back() {
        WindyOscillators source = WindyOscillators.nonlinear(1).from(START);
        double[] start = source.getState();
        double error = StudentSource.after(source, maker.get(), 1, SHORT).error();
        return moved(source, -SHORT, Phrase.REFUSES_BACK, moved -> {
            double clock = source.getTime() - START - SHORT;
            double off = StudentSource.distance(start, source.getState());
            return Phrase.NOTHING_BACK.when(moved == 0).or(() -> Phrase.CLOCK_BACK.when(Math.abs(clock + SHORT)
                    > ROUNDING, -SHORT, clock)).or(() -> Phrase.BACK.when(!(off <= TOLERATED + ASTRAY * error), SHORT,
                    off, error));
        });
    }

    /** Judges how far a step of this length moves the state, or notes that it is refused. */
    private Optional<Finding> moved(WindyOscillators source, double deltaT, Phrase refusal,
            DoubleFunction<Optional<Finding>> judge) {
        double[] before = source.getState();
        try {
            source.step(maker.get(), deltaT);
            return judge.apply(StudentSource.distance(before, source.getState()));
        } catch (EndlessLoop e) {
            return loops("a step of deltaT = " + deltaT + " s", e);
        } catch (RuntimeException e) {
            if (!StudentFailure.isRefusal(e)) {
                throw e;
            }
            return Optional.of(refusal.of(e.getMessage()));
        }
    }

    private static Optional<Finding> loops(String step, EndlessLoop loop) {
        return Optional.of(Phrase.LOOPS.of(step, StudentFailure.place(loop.getStackTrace())));
    }

    /** A source that fails from this evaluation on has to be heard of. */
    private Optional<Finding> failing(int evaluation) {
        WindyOscillators source = new WindyOscillators(1);
        source.failFromEvaluation(evaluation);
        try {
            source.step(maker.get(), H);
        } catch (RuntimeException e) {                  // it is heard of
            return Optional.empty();
        }
        return Phrase.SWALLOWS.when(source.hasFailed());
    }

    /** A derivative of NaN has to reach the state, unless the solver says that it is there. */
    private Optional<Finding> notFinite() {
        WindyOscillators source = new WindyOscillators(1);
        source.spoilDerivative();
        try {
            source.step(maker.get(), H);
        } catch (EndlessLoop e) {
            return loops("a step with a derivative of NaN", e);
        } catch (RuntimeException e) {                  // it says so
            return Optional.empty();
        }
        return Phrase.NAN_HIDDEN.when(Arrays.stream(source.getState()).noneMatch(Double::isNaN)
                && source.getEvaluations() >= evaluations(1, H));       // an iteration may end early at NaN
    }
}
