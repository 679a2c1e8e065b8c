package particles.teaching.compared;

import deSolvers.DESolver;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.teaching.declared.Method;
import particles.teaching.declared.Scheme;
import particles.teaching.declared.Step;
import particles.teaching.sources.Bodies;
import particles.teaching.sources.StudentSource;
import particles.teaching.sources.WindyOscillators;

/**
 * A solver's first steps on two sources, to be compared with those of known methods: two bodies, and a nonlinear spring
 * whose force changes with the clock; with drag for a method that treats all entries alike.
 */
public final class Agreement {
    /** Coefficients with eight digits, such as Gill's, leave 1e-9. */
    private static final double PRINTED = 5e-9;
    /** Float numbers leave 1e-8. */
    private static final double FLOAT = 5e-7;
    public static final double H = 0.1;
    private static final List<Supplier<StudentSource>> TURNS = List.of(Bodies::new, () -> off(
            WindyOscillators.nonlinear(2)));
    private static final List<Supplier<StudentSource>> ALL = List.of(Bodies::new, () -> off(
            WindyOscillators.withDrag()));

    private final List<Made> turns;
    private final List<Made> all;

    /** A step on a source; empty if it was refused. */
    private record Made(Supplier<StudentSource> source, double deltaT, Optional<double[]> end) {
    }

    /** A method, and how far its steps are from the solver's. */
    public record Match(Method method, double distance) {
        public boolean isFloat() {
            return distance > PRINTED;
        }
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
        turns = steps(maker, TURNS);
        all = steps(maker, ALL);
    }

    private static List<Made> steps(Supplier<DESolver> maker, List<Supplier<StudentSource>> sources) {
        List<Made> steps = new ArrayList<>();
        sources.forEach(source -> Stream.of(H, 2.5 * H).forEach(h -> {
            StudentSource made = source.get();
            boolean accepted = made.accepts(maker.get(), h);
            steps.add(new Made(source, h, accepted ? Optional.of(made.getState()) : Optional.empty()));
        }));
        return steps;
    }

    /** Off the exact solution, where drag and nonlinearity show. */
    private static StudentSource off(WindyOscillators source) {
        source.startAt(0.5);
        double[] s = source.getState();
        Arrays.setAll(s, k -> (1.2 + k / 16.0) * s[k]);
        source.setState(s);
        return source;
    }

    /** The largest distance of a step; infinite as soon as one is another. */
    private static double distance(List<Made> steps, Function<Double, Step> method) {
        double largest = 0;
        for (Made made : steps) {
            StudentSource source = made.source.get();
            if (made.end.isEmpty()) {
                return Double.POSITIVE_INFINITY;
            }
            method.apply(made.deltaT).make(source, made.deltaT);
            double distance = StudentSource.distance(made.end.get(), source.getState());
            if (!(distance < FLOAT)) {
                return Double.POSITIVE_INFINITY;
            }
            largest = Math.max(largest, distance);
        }
        return largest;
    }

    /** @return the known method with these steps */
    public Optional<Match> known() {
        return Arrays.stream(Method.values()).flatMap(method -> method.schemes().stream().map(scheme ->
                new Match(method, distance(scheme.particles() ? turns : all, h -> scheme)))).filter(match ->
                match.distance < FLOAT).min(Comparator.comparingDouble(Match::distance));
    }

    /** @return the distance from a method's step of {@link #H} */
    public double distance(Scheme scheme) {
        StudentSource source = turns.get(2).source.get();
        scheme.make(source, H);
        return turns.get(2).end.map(end -> StudentSource.distance(end, source.getState())).orElse(Double.NaN);
    }

    /** @return the typical mistake, in one of these methods, that makes the solver's steps */
    public Optional<Cause> mistake(Stream<Method> methods) {
        return methods.flatMap(method -> method.schemes().stream().flatMap(scheme -> Arrays.stream(Mistake.values())
                .flatMap(mistake -> cause(method, scheme, mistake).stream()))).findFirst();
    }

    private Optional<Cause> cause(Method method, Scheme scheme, Mistake mistake) {
        List<Made> made = scheme.particles() ? turns : all;
        Map<Double, List<? extends Step>> changed = made.stream().map(Made::deltaT).distinct().collect(Collectors.toMap(
                h -> h, h -> mistake.steps(scheme, h).toList()));
        return IntStream.range(0, changed.get(H).size()).filter(j -> distance(made, h -> changed.get(h).get(j))
                < PRINTED).mapToObj(j -> new Cause(method, scheme, mistake, changed.get(H).get(j))).findFirst();
    }
}
