package particles.teaching.compared;

import deSolvers.DESolver;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Stream;
import particles.teaching.declared.Method;
import particles.teaching.declared.Scheme;
import particles.teaching.declared.Step;
import particles.teaching.sources.Bodies;
import particles.teaching.sources.StudentSource;
import particles.teaching.sources.WindyOscillators;

/**
 * A solver's first steps on two bodies and on a nonlinear spring whose force changes with the clock, to be compared
 * with those of known methods; for a method that treats all entries alike with drag, too.
 */
public final class Agreement {
    /** Coefficients with eight digits, such as Gill's, leave 1e-9. */
    public static final double PRINTED = 5e-9;
    /** Float numbers leave 1e-8. */
    private static final double FLOAT = 5e-7;
    private static final List<Double> LENGTHS = List.of(0.1, 0.25);
    private static final List<Supplier<StudentSource>> SOURCES = List.of(() -> off(new WindyOscillators(2)),
            Bodies::new, () -> off(WindyOscillators.withDrag()));

    private final List<Made> made;

    /** A step on a source; empty if it was refused. */
    private record Made(Supplier<StudentSource> source, double deltaT, Optional<double[]> end) {
    }

    /** A method, one of its steps, and how far it is from the solver's. */
    public record Match(Method method, Scheme scheme, double distance) {
    }

    /**
     * A typical mistake that explains the solver's steps.
     *
     * @param method  of the method
     * @param scheme  its steps without the mistake
     * @param mistake the mistake
     * @param changed its step with it
     */
    public record Cause(Method method, Scheme scheme, Mistake mistake, Step changed) {
    }

    public Agreement(Supplier<DESolver> maker) {
        made = SOURCES.stream().flatMap(source -> LENGTHS.stream().map(h -> {
            StudentSource own = source.get();
            boolean accepted = own.accepts(maker.get(), h);
            return new Made(source, h, accepted ? Optional.of(own.getState()) : Optional.empty());
        })).toList();
    }

    /** Off the exact solution, where drag and nonlinearity show. */
    private static StudentSource off(WindyOscillators source) {
        source.startAt(0.5);
        double[] s = source.getState();
        Arrays.setAll(s, k -> (1.2 + k / 16.0) * s[k]);
        source.setState(s);
        return source;
    }

    /** The largest distance between this step and the solver's; infinite if one is off by more than float round-off. */
    private double distance(Scheme kind, Step step) {
        double largest = 0;
        for (Made one : kind.particles() ? made.subList(0, 2 * LENGTHS.size()) : made) {
            double distance = distance(one, step);
            if (!(distance < FLOAT)) {
                return Double.POSITIVE_INFINITY;
            }
            largest = Math.max(largest, distance);
        }
        return largest;
    }

    private static double distance(Made one, Step step) {
        StudentSource source = one.source.get();
        step.make(source, one.deltaT);
        return one.end.map(end -> StudentSource.distance(end, source.getState())).orElse(Double.NaN);
    }

    /**
     * @param read the solver's weights, if they could be read
     * @return the known method with these steps, at whatever times the solver evaluates
     */
    public Optional<Match> known(Optional<Scheme> read) {
        return Arrays.stream(Method.values()).flatMap(method -> method.schemes().stream().map(scheme -> new Match(
                method, scheme, distance(scheme, read.filter(own -> own.size() == scheme.size()).map(scheme::atTimesOf)
                .orElse(scheme))))).filter(match -> match.distance < FLOAT).min(Comparator
                .comparingDouble(Match::distance));
    }

    /**
     * @param methods the methods in which it may be
     * @param read    the solver's weights, if they could be read
     * @return the typical mistake that makes the solver's steps, if it is one of one method only
     */
    public Optional<Cause> mistake(Stream<Method> methods, Optional<Scheme> read) {
        List<Cause> causes = methods.flatMap(method -> method.schemes().stream().flatMap(scheme -> Arrays.stream(
                Mistake.values()).flatMap(mistake -> mistake.steps(scheme).filter(step -> (!(step instanceof Scheme)
                || read.filter(own -> own.size() == scheme.size()).isPresent()) && distance(scheme, step) < PRINTED)
                .map(step -> new Cause(method, scheme, mistake, step))))).toList();
        return causes.stream().findFirst().filter(first -> causes.stream().allMatch(one -> one.method
                == first.method));
    }
}
