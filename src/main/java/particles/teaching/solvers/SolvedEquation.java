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
import particles.teaching.contract.SolverContract;
import particles.teaching.sources.NonlinearOscillators;

/**
 * The equation that the steps of an implicit solver solve: new = a1 s + a2 s(one step before) + ... + deltaT (b1 f(one
 * place and time) + ...), whose weights are found by least squares on a law that is neither linear nor the same at all
 * times.
 *
 * @param method  the nearest method
 * @param times   the clocks of its derivatives since the start of the step, in units of deltaT
 * @param weights the weights of the old states and of the derivatives
 */
record SolvedEquation(Known method, double[] times, double[] weights) {
    /** A step this close to an equation is meant to solve it; the iteration leaves about 1e-10. */
    private static final double FITS = 1e-7;
    /** Newton iterations to 1e-10 leave 5e-14, simple ones to 1e-6 leave 1e-6; a tolerance of 1e-2 leaves 3e-5. */
    private static final double SOLVED = 1e-5;
    private static final double SAME = 1e-4;
    private static final double MUCH = 10;
    private static final double START = 0.5;
    private static final double[] STEPS = {1.0 / 8, 1.0 / 4, 3.0 / 16, 3.0 / 32, 1.0 / 16, 3.0 / 64, 1.0 / 32, 1.0 / 64,
        1.0 / 128};

    /**
     * A method's equation.
     *
     * @param old    the number of old states
     * @param places where its derivatives are, from the old state, 0, to the new one, 1; their clocks are to be there
     */
    record Known(String name, int old, double[] places, double[] weights) {
        static Known of(String line) {
            String[] parts = line.split(" \\| ");
            return new Known(parts[0], Integer.parseInt(parts[1]), KnownMethods.numbers(parts[2]),
                    KnownMethods.numbers(parts[3]));
        }

        /** @return the right clocks, and those of which one is wrong */
        List<double[]> clocks() {
            List<double[]> all = new ArrayList<>(List.of(places));
            for (int j = 0; j < places.length; j++) {
                for (double time : new double[] {0, 0.5, 1}) {
                    double[] changed = places.clone();
                    changed[j] = time;
                    all.add(changed);
                }
            }
            return all;
        }

        double residual(Supplier<DESolver> maker, double h, double amplitude) {
            Made made = Made.by(maker, h, 1, amplitude);
            return LeastSquares.misfit(made.columns(this, places), weights, made.states.get(0));
        }

        double derivatives(double[] of) {
            return Arrays.stream(of, old, of.length).sum();
        }
    }

    private static final List<Known> METHODS = KnownMethods.EQUATIONS.lines().map(Known::of).toList();

    /**
     * @param earlier whether its steps use results of earlier ones
     * @param named   whether a method is one that the class's name stands for
     * @return the equation; empty if its steps solve none that is known here
     */
    static Optional<SolvedEquation> of(Supplier<DESolver> maker, boolean earlier, Predicate<String> named) {
        SolvedEquation best = null;
        double least = FITS;
        for (double h : earlier ? new double[] {STEPS[0]} : STEPS) {
            Made made = Made.by(maker, h, earlier ? 6 : 1, 1);
            for (Known known : made.isStill() ? List.<Known>of() : METHODS) {
                for (double[] times : known.old > 1 == earlier ? known.clocks() : List.<double[]>of()) {
                    double[][] columns = made.columns(known, times);
                    double[] weights = LeastSquares.weights(columns, made.states.get(0))[0];
                    double misfit = LeastSquares.misfit(columns, weights, made.states.get(0)) / h;
                    if (misfit < (best == null ? FITS : least / MUCH)) {    // an equation with more terms fits as well
                        least = misfit;
                        best = new SolvedEquation(known, times, weights);
                    }
                }
            }
        }
        return Optional.ofNullable(best).map(found -> new SolvedEquation(METHODS.stream().filter(known -> known.old
                == found.method.old && Arrays.equals(known.places, found.method.places)).min(Comparator.comparingDouble(
                known -> distance(known, found.weights) + (named.test(known.name) ? 0 : SAME))).orElseThrow(),
                found.times, found.weights));
    }

    private static double distance(Known known, double[] weights) {
        return SolverContract.distance(known.weights, weights);
    }

    /** @return the mistake in the equation; empty if it is a known one */
    Optional<Finding> mistake() {
        if (isKnown()) {
            return IntStream.range(0, times.length).filter(j -> times[j] != method.places[j]
                    && Math.abs(weights[method.old + j]) > SAME).mapToObj(j -> Phrase.EQUATION_TIME.of(place(j),
                    Formula.time(times[j]), Formula.time(method.places[j]))).findFirst();
        }
        if (Math.abs(weights[weights.length - 1]) < SAME) {
            return Optional.of(Phrase.UNSOLVED.of(method.name, text(weights)));
        }
        double sum = method.derivatives(weights);
        double right = method.derivatives(method.weights);
        boolean same = Math.abs(sum - right) < SAME;
        return same && times.length > 1 ? Optional.empty()      // a theta method
                : Optional.of(Phrase.EQUATION.of(text(weights), method.name, text(method.weights), same ? "" : ": the"
                + " weights of the derivatives add up to " + Formula.number(rational(sum)) + " and have to make "
                + Formula.number(right) + "; does deltaT stand where deltaT/2 is meant?"));
    }

    /** @return whether the weights are those of the method, whatever the clocks */
    boolean isKnown() {
        return distance(method, weights) < SAME;
    }

    private String place(int j) {
        return method.places[j] == 0 ? "s" : method.places[j] == 1 ? "new" : "(s + new)/2";
    }

    private String text(double[] c) {
        List<String> names = new ArrayList<>(List.of("s", "s(one step before)", "s(two steps before)").subList(0,
                method.old));
        IntStream.range(0, times.length).forEach(j -> names.add("deltaT f(" + place(j) + ", "
                + Formula.time(times[j]) + ")"));
        return Formula.sum(Arrays.stream(c).map(SolvedEquation::rational).toArray(), names);
    }

    /** The least squares leave about 1e-7. */
    private static double rational(double x) {
        return Math.rint(x * 66) / 66;
    }

    /**
     * @param longest the longest deltaT that the iteration for such a law is made for (s)
     * @return the mistake of an iteration that ends too early, as the residual on a strongly nonlinear law shows
     */
    static Optional<Finding> loose(Supplier<DESolver> maker, String name, double longest) {
        Known known = METHODS.stream().filter(method -> method.name.equals(name)).findFirst().orElseThrow();
        return IntStream.rangeClosed(1, 24).mapToDouble(part -> part * longest / 24).mapToObj(h -> new double[] {h,
            known.residual(maker, h, 3)}).filter(worst -> worst[1] > SOLVED && Double.isFinite(worst[1])).max(
                Comparator.comparingDouble(worst -> worst[1])).map(worst -> Phrase.LOOSE.of(worst[0], worst[1]));
    }

    /**
     * Each round of the iteration for an implicit method makes the residual smaller by deltaT; so the exponent with
     * which it falls tells them. One round may be a method of its own, as Heun's is.
     *
     * @return the mistake of a step that is the first rounds of such an iteration
     */
    static Optional<Finding> rounds(Supplier<DESolver> maker, Scheme scheme, Optional<NamePromise> promise) {
        int rounds = scheme.size() - 1;
        return METHODS.stream().filter(known -> known.old == 1 && !scheme.isOfParticles() && rounds > 0
                && promise.map(name -> name.methods().contains(known.name)).orElse(rounds > 1 || known
                == METHODS.get(0))
                && known.residual(maker, 1.0 / 8, 1) > StrictMath.pow(2, rounds + 1.6) * known.residual(maker, 1.0 / 16,
                1)).findFirst().map(known -> Phrase.ROUNDS.of(rounds == 1 ? "one round" : rounds + " rounds",
                known.name));
    }

    /**
     * What a solver made of a source.
     *
     * @param states the latest first; NaN if the solver gave up
     * @param start  the time before the last step (s)
     */
    private record Made(NonlinearOscillators source, double h, List<double[]> states, double start) {
        static Made by(Supplier<DESolver> maker, double h, int steps, double amplitude) {
            NonlinearOscillators source = new NonlinearOscillators(2);
            source.startAt(START);
            double[] s = source.getState();
            Arrays.setAll(s, k -> amplitude * (1 + k / 64.0) * s[k]);       // off the exact solution
            source.setState(s);
            DESolver solver = maker.get();
            List<double[]> states = new ArrayList<>(List.of(s, s, s, s));
            double start = START;
            try {
                for (int step = 0; step < steps; step++) {
                    start = source.getTime();
                    solver.stepState(source, h);
                    states.add(0, source.getState());
                }
            } catch (RuntimeException e) {              // too long a step for it
                states.forEach(state -> Arrays.fill(state, Double.NaN));
            }
            return new Made(source, h, states, start);
        }

        boolean isStill() {
            return Arrays.equals(states.get(0), states.get(1));
        }

        double[][] columns(Known known, double[] times) {
            return IntStream.range(0, known.old + times.length).mapToObj(j -> j < known.old ? states.get(1 + j)
                    : rate(known.places[j - known.old], times[j - known.old])).toArray(double[][]::new);
        }

        private double[] rate(double place, double time) {
            double[] s = states.get(1);
            source.setState(Combination.plus(s, place, Combination.plus(states.get(0), -1, s)));
            source.incTime(start + time * h - source.getTime());
            double[] dSdt = new double[s.length];
            source.getStateDerivative(dSdt);
            return Combination.plus(new double[0], h, dSdt);
        }
    }
}
