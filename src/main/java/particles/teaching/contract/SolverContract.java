package particles.teaching.contract;

import deSolvers.DESolver;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.function.DoubleFunction;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.teaching.Finding;
import particles.teaching.Formula;
import particles.teaching.GuardedRun.EndlessLoop;
import particles.teaching.StudentFailure;
import particles.teaching.sources.Probe;
import particles.teaching.sources.Springs;
import particles.teaching.sources.StudentSource;
import particles.teaching.sources.WindyOscillators;

/**
 * Checks the rules that hold for every solver, whatever its formula: each step begins at the source's own state, and
 * one solver may step any number of sources.
 *
 * @param maker makes a new solver
 */
public record SolverContract(Supplier<DESolver> maker) {
    private static final double H = 1.0 / 16;
    private static final double ALIKE = 1e-2;
    private static final double ROUNDING = 1e-12;
    /** In so short a step, entries that are worked one after the other are as good as alike. */
    private static final double BRIEF = H / 64;
    /** So small that an adaptive method accepts its first step. */
    public static final double TINY = StrictMath.pow(2, -40);
    private static final double SAME = 1e-6;
    /** A tolerance shows in so long a step. */
    private static final double LONG = 1;
    private static final int SIZE = 12;
    private static final int MOST = 2000;
    private static final int LARGEST = 100_000;
    /** No special time (s). */
    private static final double START = 0.5;
    /** There a method that loses an order is off by a hundred times its error, and right ones by at most 3 times. */
    private static final double SHORT = H / 8;
    private static final double ASTRAY = 20;
    /** Less may be the tolerance of an adaptive method. */
    private static final double TOLERATED = 1e-8;
    private static final int SOME = 40;
    private static final int MANY = 200;

    /**
     * @param memory its memory
     * @return its mistakes, and advice
     */
    public List<Finding> check(SolverMemory memory) {
        Optional<Finding> mistake = memory.mistake().or(this::ofAnySize);
        return Stream.of(mistake, Phrase.CLOCK_IGNORED.when(mistake.isEmpty() && memory.ignoresTheClock()),
                back(), moved(new WindyOscillators(1), 0, Phrase.REFUSES_ZERO, moved -> Phrase.NAN_AT_ZERO.when(
                !Double.isFinite(moved)).or(() -> Phrase.MOVES_AT_ZERO.when(moved > ROUNDING, moved))),
                Phrase.FOR_PARTICLES.when(isForParticles()), failing(0), failing(1), notFinite()).flatMap(
                Optional::stream).distinct().toList();
    }

    /**
     * Steps a source much larger than that of a first example - smaller where the work in a step grows with the square
     * of the size -, one of seven numbers, into which no blocks fit, and one on a line. Their particles are equal, and
     * so are the coordinates of each. A method that does not move six equal numbers alike needs positions and
     * velocities.
     */
    private Optional<Finding> ofAnySize() {
        int particles = solvesWithMatrix() ? SOME : MANY;
        return unlike(new WindyOscillators(particles), 3, particles + " particles, " + 6 * particles, "an array or a"
                + " loop has a fixed length; source.getStateSize() has to be asked in every step").filter(finding ->
                unlike(new WindyOscillators(1), 3, "", "").isEmpty()).or(() ->
                isForParticles() || unlike(alike(6), 6, "", "").isPresent() ? Optional.empty() : unlike(alike(7), 7,
                "7", "go through the entries one by one, to source.getStateSize()")).or(() -> unlike(
                WindyOscillators.onLine(5), 1, "5 particles on a line, 10", "three coordinates are taken for granted;"
                + " ((SecondOrderStateSource) source).getDimension() says how many positions and then velocities"
                + " each particle has"));
    }

    /** @return the mistake if an entry of the new state changes with another one's state or derivative */
    public Optional<Finding> mixed() {
        double[] numbers = new Random(9).doubles(SIZE, TINY, 2 * TINY).toArray();
        double[] usual = stepWith(numbers).getState();
        return IntStream.range(0, SIZE).boxed().flatMap(j -> {
            double[] changed = numbers.clone();
            changed[j] *= -2;
            double[] other = stepWith(changed).getState();      // a velocity moves its position, too
            return IntStream.range(0, SIZE).filter(k -> k != j && (k != j - 3 || k % 6 > 2) && Math.abs(other[k]
                    - usual[k]) > SAME * TINY).mapToObj(k -> Phrase.LAYOUT.of(k, j));
        }).findFirst();
    }

    /**
     * @return the mistake of a method that makes a spring swing otherwise in another entry of the state, also where
     *         the first particle is at rest, or from the other side
     */
    public Optional<Finding> asymmetric() {
        return Stream.of(0, 3).flatMap(kind -> {        // displaced, or in motion: signs of errors are alike in one
            double[] first = swing(0, kind, 1);
            double other = distance(first, swing(8, kind, 1));
            double mirrored = distance(first, swing(0, kind, -1));
            return Phrase.LARGEST_ERROR.when(other > SAME, LONG, other).or(() -> Phrase.ABSOLUTE_ERROR.when(
                    mirrored > SAME, LONG, mirrored)).stream();
        }).findFirst();
    }

    /** @return position and velocity of a spring after a step, times the sign of its start */
    private double[] swing(int entry, int kind, double start) {
        double[] end = StudentSource.after(new Springs(entry + kind, start), maker.get(), 1, LONG).getState();
        return new double[] {start * end[entry], start * end[entry + 3]};
    }

    /** @return the mistake if a state and derivatives of 0 do not stay 0 */
    public Optional<Finding> adds() {
        double[] end = stepWith(new double[SIZE]).getState();
        return IntStream.range(0, SIZE).filter(k -> Math.abs(end[k]) > SAME).mapToObj(k -> Phrase.ADDS.of(k, end[k]))
                .findFirst();
    }

    /** @return the mistake if the clock does not move where nothing else does */
    public Optional<Finding> still() {
        double moved = (stepWith(new double[SIZE]).getTime() - START) / H;
        return Phrase.CLOCK_ENDS.when(!Formula.sameTime(moved, 1), "where state and derivative are 0, ", Formula.time(
                moved), H);
    }

    /** A source after a step from these numbers, which are the derivatives, too, and never change. */
    private Probe stepWith(double[] numbers) {
        return StudentSource.after(new Probe.OfParticles(numbers, START, (evaluation, dSdt) -> System.arraycopy(numbers,
                0, dSdt, 0, SIZE), LARGEST, false, false), maker.get(), 1, H);
    }

    private static Probe alike(int size) {
        return new Probe(new double[size], 0, (evaluation, dSdt) -> Arrays.fill(dSdt, 1), MOST);
    }

    /** @return the number of evaluations in a step of nonlinear particles; -1 if it is too long for the solver */
    public long evaluations(int particles, double deltaT) {
        try {
            return StudentSource.after(WindyOscillators.nonlinear(particles), maker.get(), 1, deltaT).getEvaluations();
        } catch (RuntimeException e) {
            return -1;
        }
    }

    /** @return whether it evaluates the derivative once more for each entry, as for a matrix of differences */
    public boolean solvesWithMatrix() {
        return evaluations(2, H) >= evaluations(1, H) + 6;
    }

    /** @return how far a source is from its start after a step of this length and one back; empty if one is refused */
    public Optional<Double> thereAndBack(StudentSource source, double deltaT) {
        double[] start = source.getState();
        return source.accepts(maker.get(), deltaT) && source.accepts(maker.get(), -deltaT)
                ? Optional.of(distance(start, source.getState())) : Optional.empty();
    }

    private Optional<Finding> unlike(StudentSource source, int d, String size, String cause) {
        boolean inTurn = evaluations(2, H) >= 2 * evaluations(1, H);
        double h = inTurn ? BRIEF : H;
        try {
            source.step(maker.get(), h);
        } catch (RuntimeException e) {
            return Phrase.SIZE_FAILS.when(d == 3 || !StudentFailure.isRefusal(e), size,
                    StudentFailure.describe(e), cause);
        }
        return Stream.concat(source.evaluatedAt().stream().filter(state -> !inTurn), Stream.of(
                source.getState())).flatMap(state -> IntStream.range(0, state.length).filter(k -> !(Math.abs(state[k]
                - state[k / d % 2 * d]) <= ALIKE * h / H))
                .mapToObj(k -> Phrase.SIZE_UNLIKE.of(size, k, state[k], k / d % 2 * d, state[k / d % 2 * d], cause)))
                .findFirst();                           // differences for a Jacobian are smaller
    }

    /** Judges a step back after one forward: clock and state, which is about as far off as that step's error. */
    private Optional<Finding> back() {
        WindyOscillators source = WindyOscillators.nonlinear(1).from(START);
        double[] start = source.getState();
        double error = StudentSource.after(source, maker.get(), 1, SHORT).error();
        return moved(source, -SHORT, Phrase.REFUSES_BACK, moved -> {
            double clock = source.getTime() - START - SHORT;
            double off = distance(start, source.getState());
            return Phrase.NOTHING_BACK.when(moved == 0).or(() -> Phrase.CLOCK_BACK.when(!Formula.sameTime(clock,
                    -SHORT), -SHORT, clock)).or(() -> Phrase.STEP_BACK.when(!(off <= TOLERATED + ASTRAY * error), SHORT,
                    off, error));
        });
    }

    /** Judges how far a step of this length moves the state, or notes that it is refused. */
    private Optional<Finding> moved(WindyOscillators source, double deltaT, Phrase refusal,
            DoubleFunction<Optional<Finding>> judge) {
        double[] before = source.getState();
        try {
            source.step(maker.get(), deltaT);
            return judge.apply(distance(before, source.getState()));
        } catch (EndlessLoop e) {
            return loops("a step of deltaT = " + deltaT + " s", "step backwards, or throw an exception that says why"
                    + " not", e);
        } catch (RuntimeException e) {
            if (!StudentFailure.isRefusal(e)) {
                throw e;
            }
            return Optional.of(refusal.of(e.getMessage()));
        }
    }

    private static Optional<Finding> loops(String step, String cure, EndlessLoop loop) {
        return Optional.of(Phrase.LOOPS.of(step, cure + StudentFailure.place(loop.getStackTrace())));
    }

    /** @return whether a solver refuses sources without positions and velocities */
    public boolean isForParticles() {
        try {
            alike(6).step(maker.get(), H);
            return false;
        } catch (RuntimeException e) {
            return !(e instanceof Probe.TooManyEvaluations);    // it works on it, for long
        }
    }

    /** A source that fails from this evaluation on has to be heard of. */
    private Optional<Finding> failing(int evaluation) {
        WindyOscillators source = new WindyOscillators(1);
        double[] before = source.getState();
        source.failFromEvaluation(evaluation);
        try {
            source.step(maker.get(), H);
            return Phrase.SWALLOWS.when(source.hasFailed());
        } catch (RuntimeException expected) {
            return Phrase.LEFT_WITHIN.when(evaluation > 0 && source.hasFailed() && (distance(before, source.getState())
                    != 0 || source.getTime() != 0));
        }
    }

    /** The check makes the derivative NaN, and says so. */
    private Optional<Finding> notFinite() {
        WindyOscillators source = new WindyOscillators(1);
        source.spoilDerivative();
        try {
            source.step(maker.get(), H);
            boolean hidden = Arrays.stream(source.getState()).noneMatch(Double::isNaN);
            return Optional.of((!hidden ? Phrase.NAN_UNNOTICED : source.getEvaluations() < evaluations(1, H)
                    ? Phrase.NAN_ENDS : Phrase.NAN_HIDDEN).of());
        } catch (EndlessLoop e) {
            return loops("this check made the derivative NaN on purpose, and the step", "end a loop that waits for a"
                    + " small error when the error is NaN", e);
        } catch (RuntimeException e) {
            return Phrase.NAN_UNSAID.when(String.valueOf(e.getMessage()).matches("\\s*|null"));
        }
    }

    /** @return the largest difference of two entries; NaN if there is one */
    public static double distance(double[] x, double[] y) {
        double distance = 0;
        for (int k = 0; k < x.length; k++) {
            distance = Math.max(distance, Math.abs(x[k] - y[k]));
        }
        return distance;
    }
}
