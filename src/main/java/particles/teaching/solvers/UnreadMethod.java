package particles.teaching.solvers;

import deSolvers.DESolver;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.teaching.Finding;
import particles.teaching.Formula;
import particles.teaching.contract.Phrase;
import particles.teaching.contract.SolverContract;
import particles.teaching.sources.Probe;
import particles.teaching.sources.Springs;
import particles.teaching.sources.StiffDecay;
import particles.teaching.sources.StudentSource;
import particles.teaching.sources.WindyOscillators;

/** Looks for mistakes of methods without fixed coefficients, in their evaluations and in the time that they reach. */
record UnreadMethod(Supplier<DESolver> maker, SolverContract contract) {
    private static final double H = 1.0 / 16;
    /** Where nothing is symmetric in time (s). */
    private static final double START = 0.5;
    private static final double LONG = 4;
    /** Shorter than a sub-step of fixed length would be. */
    private static final double BRIEF = 1e-4;
    private static final int SHORT_STEPS = 16;
    /** The oscillators start at 1.5. */
    private static final double FAR = 0.5;
    /** An iteration for an implicit method may diverge in a long step. */
    private static final double DIVERGED = 1e6;
    private static final double LITTLE = 1e-3;
    /** So much of deltaT an error has to be for the state to be that of another time. */
    private static final double FAR_OFF = 1.0 / 64;
    private static final double MUCH = 100;
    private static final double SWING = 0.5;
    private static final double ALIKE = 1e-6;
    private static final int SIZE = 12;
    /** deltaT times the decay rate; a Taylor series for the exponential has digits left there. */
    private static final double STIFF = 20;
    /** A stiff decay may be damped little or not at all, but not grow. */
    private static final double GROWS = 1.5;
    private static final double DAMPS = 0.9;
    /** A method of order 2 measures at least this. */
    static final double SECOND = 1.5;
    /** Times that are tried, in parts of deltaT: all tenths, twelfths and sixteenths are among them. */
    private static final int PARTS = 240;
    private static final double MUCH_BETTER = 0.05;

    /** @return the source after a step of a new solver */
    private <S extends StudentSource> S after(S source, double deltaT) {
        return StudentSource.after(source, maker.get(), 1, deltaT);
    }

    private static WindyOscillators windy(int particles) {
        return new WindyOscillators(particles).from(START);
    }

    /** @return the mistake if the derivative is evaluated for each entry, between two that are written */
    Optional<Finding> entryByEntry() {
        WindyOscillators source = after(windy(2), H);
        List<double[]> at = source.evaluatedAt();
        return Phrase.ENTRY_BY_ENTRY.when(source.getEvaluations() == SIZE && contract.evaluations(1, H) == SIZE / 2
                && !Arrays.equals(at.get(0), at.get(1)), SIZE);
    }

    /** @return the mistake if the derivative is evaluated at the old state and another clock, after a trial */
    Optional<Finding> rejectedClock() {
        Random random = new Random(7);
        double[] start = random.doubles(SIZE).toArray();
        Probe probe = new Probe(start, START, (evaluation, dSdt) -> Arrays.setAll(dSdt, k -> SIZE
                * random.nextDouble()), SIZE);
        Search.first(() -> {
            after(probe, LONG);
            return Optional.empty();
        });
        List<Probe.Evaluation> made = probe.recorded();
        int trial = IntStream.range(0, made.size()).filter(i -> !Arrays.equals(made.get(i).state(), start)).findFirst()
                .orElse(0);
        return Phrase.REJECTED_CLOCK.when(trial > 0 && made.get(0).time() == START && made.stream().skip(trial)
                .anyMatch(later -> !Formula.sameTime(later.time(), START) && Arrays.equals(later.state(), start)));
    }

    /**
     * @param order its measured order; one of order 1 gains nothing by the matrix unless it damps a stiff decay
     * @return the mistake of a method that solves with a matrix and is not stable; empty if it is stable
     */
    Optional<Finding> unstable(double order) {
        if (!contract.solvesWithMatrix()) {
            return Optional.empty();
        }
        double growth = 2 * StudentSource.after(new Springs(), maker.get(), 8, 4).energy();      // from 1
        return Stream.of(0.5 / StiffDecay.RATE, STIFF / StiffDecay.RATE).flatMap(deltaT -> {
            double size = after(new StiffDecay(), deltaT).size();
            return Phrase.UNSTABLE.when(!(size <= (order < SECOND ? DAMPS : GROWS)), deltaT, "y in y' = -1000 y", size)
                    .stream();
        }).findFirst().or(() -> Phrase.UNSTABLE.when(!(growth <= 20), 4.0, "the amplitude of"
                + " the spring x'' = -x", StrictMath.pow(growth, 1.0 / 16)));
    }

    /**
     * @return the mistake of a method that makes sub-steps, more of them in a longer step, and is far less accurate in
     *         one long step than in several short ones
     */
    Optional<Finding> uncontrolled() {
        double error = after(windy(1), LONG).error();
        double often = StudentSource.after(windy(1), maker.get(), SHORT_STEPS, LONG / SHORT_STEPS).error();
        boolean far = error < DIVERGED && (error > FAR || error > LITTLE && error > MUCH * often);
        return !makesSubSteps() || !far ? Optional.empty() : rejectedClock().or(() ->
                Optional.of(Phrase.UNCONTROLLED.of(error, LONG, often, SHORT_STEPS)));
    }

    /**
     * @param order its measured order
     * @return the difference of an implicit method whose order is too low from the nearest one with as many stages of
     *         those that its name stands for; without a name, from a near one of higher order
     */
    Optional<Finding> stages(NamePromise promise, double order) {
        return StepReading.of(maker, H, 1, 1, Probe.MOST_EVALUATIONS, true).flatMap(step -> {
            Scheme found = step.scheme().ofTheEnd();
            Comparison nearest = Comparison.nearest(KnownMethods.STAGES.stream().filter(known -> known.size()
                    == found.size() && known.isOfParticles() == found.isOfParticles() && (!promise.isGiven()
                    || promise.methods().contains(known.name()))).toList(), found, step);
            return nearest.first().filter(difference -> order < (promise.isGiven() ? promise.order()
                    : nearest.known().order()) - 0.5 && (promise.isGiven() || nearest.isNamed()
                    || nearest.differences().size() == 1));
        });
    }

    /** @return whether a longer step has many more parts, as with step-size control */
    boolean makesSubSteps() {
        return times(LONG) > SHORT_STEPS / 2 * times(LONG / SHORT_STEPS);
    }

    private int times(double deltaT) {
        WindyOscillators source = windy(1);
        source.accepts(maker.get(), deltaT);
        return source.times();
    }

    /** @return the mistake of a method whose last sub-step leads beyond t + deltaT; the clock may be set back */
    Optional<Finding> uncut() {
        return IntStream.rangeClosed(1, 16).mapToObj(part -> otherTime(part / 4.0, LITTLE)).flatMap(Optional::stream)
                .filter(place -> place > 1).findFirst().map(place -> Phrase.PARTS.of(Formula.time(place)));
    }

    /** @return the mistake if the state after a very short or a longer step is that of another time than t + deltaT */
    Optional<Finding> elsewhere() {
        return Stream.of(BRIEF, H).flatMap(deltaT -> otherTime(deltaT, MUCH_BETTER).stream().map(place -> place != 0
                ? Phrase.ELSEWHERE.of(deltaT, Formula.time(place), place) : (contract.evaluations(1, deltaT) > 0
                && !makesSubSteps() ? Phrase.STAYS_AT_GUESS : Phrase.STAYS).of(deltaT))).findFirst();
    }

    /** The time, in units of deltaT, that suits the state after a step far better than the step's end. */
    private Optional<Double> otherTime(double deltaT, double better) {
        WindyOscillators source = after(new WindyOscillators(1), deltaT);
        double error = source.error();
        double place = best(source, deltaT, best(source, deltaT, 1, 1), 1.0 / PARTS);
        return Optional.of(Math.rint(PARTS * place) / PARTS).filter(time -> error > FAR_OFF * deltaT && error(source,
                deltaT, place) < better * error);
    }

    private static double best(WindyOscillators source, double deltaT, double centre, double width) {
        return IntStream.rangeClosed(-PARTS, PARTS).mapToObj(part -> centre + width * part / PARTS).min(
                Comparator.comparingDouble(place -> error(source, deltaT, place))).orElseThrow();
    }

    private static double error(WindyOscillators source, double deltaT, double place) {
        source.incTime(deltaT * place - source.getTime());
        return source.error();
    }

    /**
     * @return the mistake of a method that does not end where it began after a step and one back, as a symmetric one
     *         does; empty if it refuses such a step
     */
    Optional<Finding> irreversible(String promised) {
        return contract.thereAndBack(WindyOscillators.nonlinear(1).from(START), SWING).filter(off -> off > ALIKE).map(
                off -> Phrase.IRREVERSIBLE.of(promised, SWING, off));
    }

    /** @return the exponent with which the error of the first step falls with deltaT */
    double firstOrder() {
        return StrictMath.log(after(windy(1), H).error() / after(windy(1), H / 4).error()) / StrictMath.log(4);
    }
}
