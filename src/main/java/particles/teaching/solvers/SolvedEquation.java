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

    /** A derivative in an equation: at s + place (new - s) and t + time deltaT. */
    private record Term(double place, double time) {
        String text() {
            return place == 0 ? "deltaT f(s, t)" : place == 1 ? "deltaT f(new, t + deltaT)"
                    : "deltaT f((s + new)/2, t + deltaT/2)";
        }
    }

    /** A method's equation: as many old states, then its terms, with these weights. */
    private record Known(String name, int old, List<Term> terms, double... weights) {

        /** @return the equation, and those in which the clock of one term is another one */
        List<List<Term>> clocks() {
            List<List<Term>> all = new ArrayList<>(List.of(terms));
            for (int j = 0; j < terms.size(); j++) {
                for (double time : new double[] {0, 0.5, 1}) {
                    List<Term> changed = new ArrayList<>(terms);
                    changed.set(j, new Term(terms.get(j).place, time));
                    all.add(changed);
                }
            }
            return all;
        }

        double distance(double[] others) {
            return IntStream.range(0, weights.length).mapToDouble(j -> Math.abs(weights[j] - others[j])).sum();
        }

        double residual(Supplier<DESolver> maker, double h, double amplitude) {
            Made made = Made.by(maker, h, 1, amplitude);
            return misfit(made.columns(old, terms), weights, made.next);
        }

        double derivatives(double[] of) {
            return Arrays.stream(of, old, of.length).sum();
        }
    }

    private static final Term NEW = new Term(1, 1);
    private static final List<Term> ENDS = List.of(new Term(0, 0), NEW);
    private static final List<Known> METHODS = List.of(new Known(KnownMethods.BACKWARD_EULER, 1, ENDS, 1, 0, 1),
            new Known(KnownMethods.TRAPEZOID, 1, ENDS, 1, 0.5, 0.5),
            new Known(KnownMethods.IMPLICIT_MIDPOINT, 1, List.of(new Term(0.5, 0.5)), 1, 1),
            new Known("the BDF formula of order 2", 2, List.of(NEW), 4.0 / 3, -1.0 / 3, 2.0 / 3),
            new Known("the BDF formula of order 3", 3, List.of(NEW), 18.0 / 11, -9.0 / 11, 2.0 / 11, 6.0 / 11));

    private final Known nearest;
    private final List<Term> terms;
    private final double[] weights;

    private SolvedEquation(Known nearest, List<Term> terms, double[] weights) {
        this.nearest = nearest;
        this.terms = terms;
        this.weights = weights;
    }

    /**
     * @param earlier whether its steps use results of earlier ones
     * @param named   whether a method is one that the class's name stands for
     * @return the equation; empty if its steps solve none that is known here
     */
    static Optional<SolvedEquation> of(Supplier<DESolver> maker, boolean earlier, Predicate<String> named) {
        List<Known> methods = METHODS.stream().filter(known -> known.old > 1 == earlier).toList();
        SolvedEquation best = null;
        double least = FITS;
        for (double h : earlier ? new double[] {1.0 / 8} : STEPS) {
            Made made = Made.by(maker, h, earlier ? 6 : 1, 1);
            for (Known known : methods) {
                for (List<Term> terms : known.clocks()) {
                    double misfit = misfit(made.columns(known.old, terms), known.weights, made.next) / h;
                    if (misfit < least) {
                        least = misfit;
                        best = new SolvedEquation(known, terms, known.weights);
                    }
                }
            }
        }
        Made made = Made.by(maker, 1.0 / 8, earlier ? 6 : 1, 1);
        for (Known shape : best == null ? methods : List.<Known>of()) {
            double[][] columns = made.columns(shape.old, shape.terms);
            double[] found = LeastSquares.weights(columns, made.next);
            if (misfit(columns, found, made.next) < FITS / 8) {
                Known nearest = methods.stream().filter(known -> known.old == shape.old && known.terms.equals(
                        shape.terms)).min(Comparator.comparingDouble(known -> known.distance(found) + (named.test(
                        known.name) ? 0 : SAME))).orElseThrow();
                return Optional.of(new SolvedEquation(nearest, shape.terms, found));
            }
        }
        return Optional.ofNullable(best);
    }

    boolean isRight() {
        return isKnown() && terms.equals(nearest.terms);
    }

    /** @return the mistake in the equation; empty if it is a known one */
    Optional<Finding> mistake() {
        if (isRight()) {
            return Optional.empty();
        }
        if (isKnown()) {
            int j = IntStream.range(0, terms.size()).filter(i -> !terms.get(i).equals(nearest.terms.get(i))).findFirst()
                    .orElseThrow();
            double place = terms.get(j).place;
            return Optional.of(Phrase.EQUATION_TIME.of(place == 0 ? "at the start" : place == 1 ? "at the end"
                    : "half way", Formula.time(terms.get(j).time), Formula.time(place)));
        }
        if (Math.abs(weights[weights.length - 1]) < SAME) {
            return Optional.of(Phrase.UNSOLVED.of(nearest.name, text(weights)));
        }
        double sum = nearest.derivatives(weights);
        double right = nearest.derivatives(nearest.weights);
        boolean theta = nearest.terms.equals(ENDS) && Math.abs(sum - 1) < SAME;
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
        return nearest.distance(weights) < SAME;
    }

    private String text(double[] c) {
        List<String> names = new ArrayList<>(List.of("s", "s(one step before)", "s(two steps before)").subList(0,
                nearest.old));
        terms.forEach(term -> names.add(term.text()));
        return Formula.sum(Arrays.stream(c).map(x -> Math.rint(x * 66) / 66).toArray(), names);
    }

    /**
     * @param longest the longest deltaT that the iteration for such a law is made for (s)
     * @return the mistake of an iteration that ends too early, as the residual on a strongly nonlinear law shows
     */
    static Optional<Finding> loose(Supplier<DESolver> maker, String name, double longest) {
        Known known = METHODS.stream().filter(method -> method.name.equals(name)).findFirst().orElseThrow();
        double worst = 0;
        double at = 0;
        for (int part = 1; part <= 24; part++) {
            double h = part * longest / 24;
            double residual = known.residual(maker, h, 3);
            if (residual > worst && Double.isFinite(residual)) {
                worst = residual;
                at = h;
            }
        }
        return worst <= SOLVED ? Optional.empty() : Optional.of(Phrase.LOOSE.of(at, worst));
    }

    /**
     * Each round of the iteration for an implicit method makes the residual smaller by deltaT; so the exponent with
     * which it falls tells them. One round may be a method of its own, as Heun's is.
     *
     * @return the mistake of a step that is the first rounds of such an iteration
     */
    static Optional<Finding> rounds(Supplier<DESolver> maker, Scheme scheme, Optional<NamePromise> promise) {
        int evaluations = scheme.size();
        return METHODS.stream().filter(known -> known.old == 1 && !scheme.isOfParticles()
                && (evaluations > 2 || promise.filter(name ->
                name.methods().contains(known.name)).isPresent() || promise.isEmpty() && known == METHODS.get(0)))
                .filter(known -> StrictMath.log(known.residual(maker, 1.0 / 8, 1) / known.residual(maker, 1.0 / 16, 1))
                > (evaluations + 0.6) * StrictMath.log(2)).findFirst().map(known -> Phrase.ROUNDS.of(evaluations == 2
                ? "one round" : evaluations - 1 + " rounds", known.name));
    }

    /** What a solver made of a source: the states before, latest first, and the new one. */
    private record Made(NonlinearOscillators source, double h, List<double[]> before, double[] next, double start) {
        /** Its numbers are infinite if the solver gave up. */
        static Made by(Supplier<DESolver> maker, double h, int steps, double amplitude) {
            NonlinearOscillators source = new NonlinearOscillators(2);
            source.startAt(START);
            double[] s = source.getState();
            Arrays.setAll(s, k -> amplitude * (1 + k / 64.0) * s[k]);       // no two entries alike
            source.setState(s);
            DESolver solver = maker.get();
            List<double[]> before = new ArrayList<>();
            double start = START;
            try {
                for (int step = 0; step < steps; step++) {
                    before.add(0, source.getState());
                    start = source.getTime();
                    solver.stepState(source, h);
                }
            } catch (RuntimeException e) {              // too long a step for it
                return new Made(source, h, before, new double[] {Double.POSITIVE_INFINITY}, start);
            }
            return new Made(source, h, before, source.getState(), start);
        }

        double[][] columns(int old, List<Term> terms) {
            return IntStream.range(0, old + terms.size()).mapToObj(j -> j < old ? before.get(Math.min(j, before.size()
                    - 1)) : rate(terms.get(j - old))).toArray(double[][]::new);
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
