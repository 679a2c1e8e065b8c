package particles.teaching.solvers;

import deSolvers.DESolver;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import particles.teaching.Finding;
import particles.teaching.Formula;
import particles.teaching.sources.NonlinearOscillators;

/**
 * The equation that the steps of an implicit solver solve: new = a1 s + a2 s(one step before) + ... + deltaT (b1 f(one
 * place and time) + ...), whose weights are found by least squares on a law that is neither linear nor the same at all
 * times.
 */
final class SolvedEquation {
    /** A step this close to an equation is meant to solve it; the iteration leaves about 1e-10. */
    private static final double FITS = 1e-7;
    /** Newton iterations to 1e-10 leave 5e-14, simple ones to 1e-6 leave 1e-6; a tolerance of 1e-2 leaves 3e-5. */
    private static final double SOLVED = 1e-5;
    private static final double SAME = 1e-4;
    private static final double START = 0.5;
    private static final double[] STEPS = {1.0 / 4, 3.0 / 16, 1.0 / 8, 3.0 / 32, 1.0 / 16, 3.0 / 64, 1.0 / 32, 1.0 / 64,
        1.0 / 128};
    private static final int MOST_ROUNDS = 14;

    /** A derivative in an equation: at s + place (new - s) and t + time deltaT. */
    private record Term(String name, double place, double time) {
    }

    private static final Term NOW = new Term("deltaT f(s, t)", 0, 0);
    private static final Term NEW = new Term("deltaT f(new, t + deltaT)", 1, 1);
    private static final Term HALF = new Term("deltaT f((s + new)/2, t + deltaT/2)", 0.5, 0.5);
    private static final String AT_END = "the derivative at the end of the step is taken at the clock t; move the clock"
            + " to t + deltaT before it";

    /** The terms of an equation, the mistake in their clocks, and the methods that have such terms. */
    private record Shape(int old, List<Term> terms, String clock, List<Known> methods) {
    }

    private record Known(String name, double... weights) {
    }

    private static final List<Known> ENDS = List.of(new Known(KnownMethods.BACKWARD_EULER, 1, 0, 1),
            new Known(KnownMethods.TRAPEZOID, 1, 0.5, 0.5));
    private static final List<Known> MIDDLE = List.of(new Known(KnownMethods.IMPLICIT_MIDPOINT, 1, 1));

    private static final List<Shape> ONE_STEP = List.of(
            new Shape(1, List.of(NOW, NEW), "", ENDS),
            new Shape(1, List.of(HALF), "", MIDDLE),
            new Shape(1, List.of(NOW, new Term("deltaT f(new, t)", 1, 0)), AT_END, ENDS),
            new Shape(1, List.of(new Term("deltaT f(s, t + deltaT)", 0, 1), NEW),
                    "both derivatives are taken at the clock t + deltaT; take the"
                    + " one at the start before the clock moves", ENDS),
            new Shape(1, List.of(new Term("deltaT f((s + new)/2, t)", 0.5, 0)),
                    "the derivative half way is taken at the clock t; move the clock"
                    + " to t + deltaT/2 before it", MIDDLE),
            new Shape(1, List.of(new Term("deltaT f((s + new)/2, t + deltaT)", 0.5, 1)),
                    "the derivative half way is taken at the clock t + deltaT; the"
                    + " clock has to stand at t + deltaT/2", MIDDLE));
    private static final List<Shape> EARLIER = List.of(
            new Shape(2, List.of(NEW), "", List.of(new Known("the BDF formula of order 2", 4.0 / 3, -1.0 / 3, 2.0
                    / 3))),
            new Shape(3, List.of(NEW), "", List.of(new Known("the BDF formula of order 3", 18.0 / 11, -9.0 / 11,
                    2.0 / 11, 6.0 / 11))));

    private final Shape shape;
    private final double[] weights;
    private final Known nearest;

    private SolvedEquation(Shape shape, double[] weights, Predicate<String> named) {
        this.shape = shape;
        this.weights = weights;
        nearest = shape.methods.stream().min(Comparator.comparingDouble(known -> distance(known.weights, weights)
                + (named.test(known.name) ? 0 : SAME))).orElseThrow();
    }

    private static double distance(double[] x, double[] y) {
        return IntStream.range(0, x.length).mapToDouble(j -> Math.abs(x[j] - y[j])).sum();
    }

    /**
     * @param earlier whether its steps use results of earlier ones
     * @param named   whether a method is one that the class's name stands for
     * @return the equation; empty if its steps solve none that is known here
     */
    static Optional<SolvedEquation> of(Supplier<DESolver> maker, boolean earlier, Predicate<String> named) {
        SolvedEquation best = null;
        double least = FITS;
        List<Shape> shapes = earlier ? EARLIER : ONE_STEP;
        for (double h : earlier ? new double[] {1.0 / 8} : STEPS) {
            Made made = Made.by(maker, h, earlier ? 6 : 1, 1);
            for (Shape shape : shapes) {
                for (Known known : shape.methods) {
                    double misfit = misfit(made.columns(shape), known.weights, made.next) / h;
                    if (misfit < least) {
                        least = misfit;
                        best = new SolvedEquation(shape, known.weights, named);
                    }
                }
            }
        }
        Made made = Made.by(maker, 1.0 / 8, earlier ? 6 : 1, 1);
        for (Shape shape : best == null ? shapes : List.<Shape>of()) {
            double[][] columns = made.columns(shape);
            double[] found = LeastSquares.weights(columns, made.next);
            if (misfit(columns, found, made.next) < FITS / 8) {
                return Optional.of(new SolvedEquation(shape, found, named));
            }
        }
        return Optional.ofNullable(best);
    }

    boolean isRight() {
        return shape.clock.isEmpty() && distance(weights, nearest.weights) < SAME;
    }

    /** @return the mistake in the equation; empty if it is a known one */
    Optional<Finding> mistake() {
        if (isRight()) {
            return Optional.empty();
        }
        if (IntStream.range(shape.old, weights.length).allMatch(j -> Math.abs(weights[j]) < SAME || shape.terms.get(j
                - shape.old).place == 0)) {
            return Optional.of(Phrase.UNSOLVED.of(nearest.name, text(weights)));
        }
        if (distance(weights, nearest.weights) < SAME) {
            boolean both = nearest.name.equals(KnownMethods.TRAPEZOID) && shape.clock.equals(AT_END);
            return Optional.of(Phrase.EQUATION_TIME.of(both ? "both derivatives are taken at the clock t; move the"
                    + " clock to t + deltaT before the one at the end" : shape.clock));
        }
        double sum = IntStream.range(shape.old, weights.length).mapToDouble(j -> weights[j]).sum();
        double right = IntStream.range(shape.old, weights.length).mapToDouble(j -> nearest.weights[j]).sum();
        boolean theta = shape.old == 1 && shape.clock.isEmpty() && shape.terms.size() == 2 && Math.abs(sum - 1) < SAME;
        return theta ? Optional.empty() : Optional.of(Phrase.EQUATION.of(text(weights), nearest.name, text(
                nearest.weights), Math.abs(sum - right) < SAME ? "" : ": the weights of the derivatives add up to "
                + Formula.number(Math.rint(sum * 66) / 66) + " and have to make " + Formula.number(right)
                + "; does deltaT stand where deltaT/2 is meant?"));
    }

    /** @return the method that solves this equation, or the nearest */
    String name() {
        return nearest.name;
    }

    /** @return whether the weights are those of the method, whatever the clocks */
    boolean isKnown() {
        return distance(weights, nearest.weights) < SAME;
    }

    private String text(double[] c) {
        List<String> names = new ArrayList<>(List.of("s", "s(one step before)", "s(two steps before)").subList(0,
                shape.old));
        shape.terms.forEach(term -> names.add(term.name));
        double[] shown = Arrays.stream(c).map(x -> Math.rint(x * 66) / 66).toArray();
        return Formula.sum(distance(c, shown) < SAME ? shown : c, names);
    }

    /**
     * @param longest the longest deltaT that the iteration for such a law is made for (s)
     * @return the mistake of an iteration that ends too early, as the residual on a strongly nonlinear law shows
     */
    static Optional<Finding> loose(Supplier<DESolver> maker, String name, double longest) {
        Shape shape = MIDDLE.get(0).name.equals(name) ? ONE_STEP.get(1) : ONE_STEP.get(0);
        Known known = shape.methods.stream().filter(method -> method.name.equals(name)).findFirst().orElseThrow();
        double worst = 0;
        double at = 0;
        for (int part = 1; part <= 24; part++) {
            double h = part * longest / 24;
            Made made = Made.by(maker, h, 1, 3);
            double residual = misfit(made.columns(shape), known.weights, made.next);
            if (residual > worst && Double.isFinite(residual)) {
                worst = residual;
                at = h;
            }
        }
        return worst <= SOLVED ? Optional.empty() : Optional.of(Phrase.LOOSE.of(at, worst));
    }

    /** @return the mistake of an explicit step that is the first rounds of the iteration for an implicit method */
    static Optional<Finding> rounds(Scheme scheme, Optional<NamePromise> promise) {
        int n = scheme.size();
        for (int method = 0; method < 3 && !scheme.isOfParticles(); method++) {
            double place = method == 1 ? 0.5 : 1;
            double now = method == 2 ? 0.5 : 0;
            String name = KnownMethods.IMPLICIT.get(method);
            boolean named = promise.filter(p -> p.methods().contains(name)).isPresent();
            boolean useless = promise.isEmpty() && method == 0;    // the others are of order 2, as Heun's method
            for (int first = named || useless ? 0 : 1; first < 2 && n <= MOST_ROUNDS && n > 1; first++) {
                double[][] rows = new double[n + 1][n + 1];
                double[] times = new double[n];
                for (int i = 0; i <= n; i++) {
                    rows[i][0] = 1;
                    boolean euler = i < 2 && first == 0;
                    if (i > 0) {
                        rows[i][1] += (i == n ? 1 : place) * (euler ? 0 : now);
                        rows[i][i] += (i == n ? 1 : place) * (euler ? 1 : 1 - now);
                        times[Math.min(i, n - 1)] = place;
                    }
                }
                times[0] = first == 0 ? 0 : place;
                boolean same = IntStream.range(0, n).allMatch(i -> Combination.same(rows[i], scheme.stages().get(i)
                        .weights()) && Formula.sameTime(times[i], scheme.times()[i]));
                if (same && Combination.same(rows[n], scheme.ends().get(0).weights())) {
                    return Optional.of(Phrase.ROUNDS.of(n == 2 ? "one round" : n - 1 + " rounds", name));
                }
            }
        }
        return Optional.empty();
    }

    /** What a solver made of a source: the states before, latest first, and the new one. */
    private record Made(NonlinearOscillators source, double h, List<double[]> before, double[] next, double start) {
        /** Its numbers are infinite if the solver gave up. */
        static Made by(Supplier<DESolver> maker, double h, int steps, double amplitude) {
            NonlinearOscillators source = new NonlinearOscillators(2);
            source.startAt(START);
            double[] s = source.state();
            Arrays.setAll(s, k -> amplitude * (1 + k / 64.0) * s[k]);       // no two entries alike
            source.setState(s);
            DESolver solver = maker.get();
            List<double[]> before = new ArrayList<>();
            double start = START;
            try {
                for (int step = 0; step < steps; step++) {
                    before.add(0, source.state());
                    start = source.getTime();
                    solver.stepState(source, h);
                }
            } catch (RuntimeException e) {              // too long a step for it
                return new Made(source, h, before, new double[] {Double.POSITIVE_INFINITY}, start);
            }
            return new Made(source, h, before, source.state(), start);
        }

        double[][] columns(Shape shape) {
            double[][] columns = new double[shape.old + shape.terms.size()][];
            for (int j = 0; j < columns.length; j++) {
                columns[j] = j < shape.old ? before.get(Math.min(j, before.size() - 1))
                        : rate(shape.terms.get(j - shape.old));
            }
            return columns;
        }

        private double[] rate(Term term) {
            double[] s = before.get(0);
            double[] trial = Combination.plus(s, term.place, Combination.plus(next, -1, s));
            if (next.length < s.length) {
                return new double[s.length];
            }
            source.setState(trial);
            source.incTime(start + term.time * h - source.getTime());
            double[] dSdt = new double[s.length];
            source.getStateDerivative(dSdt);
            return Arrays.stream(dSdt).map(x -> h * x).toArray();
        }
    }

    private static double misfit(double[][] columns, double[] c, double[] expected) {
        double largest = 0;
        for (int k = 0; k < expected.length; k++) {
            double sum = -expected[k];
            for (int j = 0; j < c.length; j++) {
                sum += c[j] * columns[j][k];
            }
            largest = Math.abs(sum) <= largest ? largest : Math.abs(sum);
        }
        return Double.isNaN(largest) ? Double.POSITIVE_INFINITY : largest;
    }
}
