package particles.teaching.solvers;

import deSolvers.DESolver;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Predicate;
import java.util.function.Supplier;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.teaching.Finding;
import particles.teaching.Formula;
import particles.teaching.contract.Phrase;
import particles.teaching.contract.SolverContract;
import particles.teaching.sources.OrderMeasurement;
import particles.teaching.sources.Probe;
import particles.teaching.sources.WindyOscillators;

/**
 * The equation that a step solves: new = a1 s + a2 s(1 step before) + ... + deltaT (b1 f(one place and time) + ...). It
 * is the one of a table, of known methods and of their known changes, that the steps on a law fulfil which is neither
 * linear nor the same at all times. The weights of a multistep method are read by probes.
 *
 * @param name    the name of the method
 * @param mistake its change; empty for the method itself
 * @param places  where the derivatives are: 0 is the old state, 1 the new one, -1 the one before
 * @param times   their clocks since the start of the step, in units of deltaT
 * @param weights the weights of the old states and of the derivatives
 */
record SolvedEquation(String name, String mistake, double[] places, double[] times, double[] weights) {
    /** A step this close to an equation is meant to solve it; the iteration leaves about 1e-10. */
    private static final double FITS = 1e-7;
    /** Newton iterations to 1e-10 leave 5e-14, simple ones to 1e-6 leave 1e-6; a tolerance of 1e-2 leaves 3e-5. */
    private static final double SOLVED = 1e-5;
    private static final double START = 0.5;
    /** In this step (s) an accurate method is off these equations by 1e-3 or more. */
    private static final double NEAR_STEP = 1.0 / 8;
    private static final double NEAR = 1e-4;
    private static final double[] STEPS = KnownMethods.numbers("1/8 1/4 3/16 3/32 1/16 3/64 1/32 1/64 1/128");
    private static final List<SolvedEquation> ALL = KnownMethods.EQUATIONS.lines().map(line -> line.split(" *[|] *",
            -1)).map(parts -> new SolvedEquation(parts[0], parts[3], KnownMethods.numbers(parts[1]),
            KnownMethods.numbers(parts[parts.length == 4 ? 1 : 4]), KnownMethods.numbers(parts[2]))).toList();

    private static SolvedEquation named(String name) {
        return ALL.stream().filter(known -> known.name.equals(name)).findFirst().orElseThrow();
    }

    private int old() {
        return weights.length - places.length;
    }

    private boolean isAdams() {
        return Arrays.stream(places).anyMatch(place -> place < 0);
    }

    private boolean isOneStep() {
        return old() == 1 && !isAdams() && mistake.isEmpty() && Arrays.equals(places, times);
    }

    /**
     * @param earlier whether its steps use results of earlier ones
     * @return the equation; empty if its steps solve none that is known
     */
    static Optional<SolvedEquation> of(Supplier<DESolver> maker, boolean earlier) {
        return Arrays.stream(STEPS).limit(earlier ? 1 : STEPS.length).boxed().flatMap(h -> {
            Made made = Made.by(maker, WindyOscillators.nonlinear(2), h, earlier ? 6 : 1, 1);
            return ALL.stream().filter(known -> known.old() > 1 == earlier && !known.isAdams() && made.misfit(known)
                    < FITS * h);
        }).findFirst();
    }

    /**
     * @return the name of a method with one step whose equation is nearly fulfilled, as by a loose iteration, or which
     *         is all that is left of it where nothing moves, after its first round
     */
    static Optional<String> near(Supplier<DESolver> maker) {
        Optional<Scheme> round = StepReading.of(maker, NEAR_STEP, SolverContract.TINY, 1,
                Probe.MOST_EVALUATIONS, false).map(StepReading::scheme).filter(scheme ->
                !scheme.isOfParticles()).map(Scheme::ofTheEnd);
        return ALL.stream().filter(known -> known.isOneStep() && (known.residual(maker, NEAR_STEP, 1) < NEAR
                || round.filter(scheme -> Arrays.equals(scheme.times(), known.times) && Combination.same(scheme.rows()
                .get(scheme.size()), known.weights)).isPresent())).map(SolvedEquation::name).findFirst();
    }

    /** @return the weights of the seventh step of a multistep method; empty if they are not fixed */
    static Optional<SolvedEquation> ofEarlierSteps(Supplier<DESolver> maker) {
        return StepReading.of(maker, 1.0 / 16, 1, 7, Probe.MOST_EVALUATIONS, false).filter(reading ->
                !reading.scheme().isOfParticles()).map(step -> {
            int n = step.evaluations();
            TreeMap<Double, Double> found = new TreeMap<>(Comparator.reverseOrder());
            IntStream.range(0, n).forEach(j -> found.merge(Math.rint(step.scheme().times()[j] * 1e9) / 1e9,
                    step.scheme().rows().get(n)[1 + j] - step.before()[1 + j], Double::sum));
            found.values().removeIf(weight -> Formula.same(weight, 0));     // evaluated twice at a time: with a
            double[] times = found.keySet().stream().mapToDouble(t -> t).toArray();         // better state
            return new SolvedEquation("", "", times, times, DoubleStream.concat(DoubleStream.of(1), found.values()
                    .stream().mapToDouble(weight -> weight)).toArray());
        }).filter(found -> found.times.length > 0);
    }

    /**
     * @param measured its order
     * @param wanted   the lowest order that it should have
     * @return the mistake in the weights of a multistep method, or in its first steps
     */
    Optional<Finding> wrongWeights(OrderMeasurement measured, int wanted) {
        int order = times.length;
        boolean poor = !(measured.order() > wanted - 0.5);
        Predicate<SolvedEquation> same = known -> Combination.same(weights, known.weights);
        Predicate<SolvedEquation> twice = known -> known.times.length > order && Formula.same(known.weights[1],
                weights[1]) && Formula.same(Combination.sum(weights), 2);
        return Stream.of(same, twice, known -> Arrays.equals(times, known.times)).flatMap(suits -> ALL.stream().filter(
                SolvedEquation::isAdams).filter(suits)).findFirst().flatMap(known -> !Arrays.equals(times, known.times)
                ? Phrase.TOO_OLD.when(poor, row().formula(), known.name, known.row().formula()) : same.test(known)
                ? Phrase.START.when(measured.order() < order - 0.5, order, measured.digits(), order - 1)
                : Comparison.near(row(), known.row(), known.name).filter(finding -> poor)).or(() ->
                Phrase.WEIGHTS_SUM.when(poor && !Formula.same(Combination.sum(weights), 2), Combination.sum(weights)
                - 1)).or(() -> Phrase.ONE_ARRAY.when(poor && order == 1, row().formula()));
    }

    /** @return the mistake in the equation; empty if it is the method's */
    Optional<Finding> wrong(NamePromise promise) {
        Optional<Integer> off = IntStream.range(0, times.length).filter(j -> times[j] != places[j]).boxed().findFirst();
        SolvedEquation known = ALL.stream().filter(one -> off.isPresent() && Arrays.equals(times, one.times)
                && promise.methods().contains(one.name)).findFirst().orElse(named(name));
        return Phrase.EQUATION.when(!mistake.isEmpty() || !known.name.equals(name), row().formula(), known.name,
                known.row().formula(), mistake).or(() -> off.map(j -> Phrase.EQUATION_TIME.of(place(j), Formula.time(
                times[j]), Formula.time(places[j]))));
    }

    private String place(int j) {
        return places[j] == 0 ? "s" : places[j] == 1 ? "new" : "(s + new)/2";
    }

    private Combination row() {
        List<String> names = new ArrayList<>(List.of("s", "s(1 step before)", "s(2 steps before)",
                "s(3 steps before)").subList(0, old()));
        IntStream.range(0, times.length).forEach(j -> names.add("deltaT f(" + (isAdams() ? "" : place(j) + ", ")
                + Formula.time(times[j]) + ")"));
        return new Combination("the new state is", names, 0, old(), weights);
    }

    private double residual(Supplier<DESolver> maker, double h, double amplitude) {
        return Made.by(maker, WindyOscillators.nonlinear(2), h, 1, amplitude).misfit(this);
    }

    /**
     * @param matrix whether it solves with a matrix, which is made for longer steps than other iterations, and solves a
     *               linear law in one go
     * @return the mistake of a wrong matrix, or of an iteration that ends too early, as the residual on a strongly
     *         nonlinear law shows
     */
    static Optional<Finding> loose(Supplier<DESolver> maker, String name, boolean matrix) {
        SolvedEquation known = named(name);
        double longest = matrix ? 0.5 : 3.0 / 32;
        double linear = matrix ? Made.by(maker, new WindyOscillators(2), NEAR_STEP, 1, 1).misfit(known) : 0;
        return IntStream.rangeClosed(1, 24).mapToDouble(part -> part * longest / 24).mapToObj(h -> new double[] {h,
            known.residual(maker, h, 3)}).filter(worst -> worst[1] > SOLVED && Double.isFinite(worst[1])).max(
                Comparator.comparingDouble(worst -> worst[1])).map(worst -> linear > SOLVED ? Phrase.MATRIX.of(
                name, linear) : Phrase.LOOSE.of(worst[0], worst[1]));
    }

    /**
     * Each round of the iteration for an implicit method makes the residual smaller by deltaT; so the exponent with
     * which it falls tells them. One round may be a method of its own, as Heun's is.
     *
     * @return the mistake of a step that is the first rounds of such an iteration
     */
    static Optional<Finding> rounds(Supplier<DESolver> maker, Scheme scheme, NamePromise promise) {
        int rounds = scheme.size() - 1;
        return ALL.stream().filter(known -> known.isOneStep() && !scheme.isOfParticles() && rounds > 0
                && (promise.isGiven() ? promise.methods().contains(known.name) : rounds > 1)
                && known.residual(maker, 1.0 / 8, 1) > StrictMath.pow(2, rounds + 1.6) * known.residual(maker, 1.0 / 16,
                1)).findFirst().map(known -> Phrase.ROUNDS.of(rounds == 1 ? "one round" : rounds + " rounds",
                known.name));
    }

    /**
     * What a solver made of a source.
     *
     * @param steps  the number of steps
     * @param states the latest first; NaN if the solver gave up
     */
    private record Made(WindyOscillators source, double h, int steps, List<double[]> states) {
        static Made by(Supplier<DESolver> maker, WindyOscillators source, double h, int steps, double amplitude) {
            source.startAt(START);
            double[] s = source.getState();
            Arrays.setAll(s, k -> amplitude * (1 + k / 64.0) * s[k]);       // off the exact solution
            source.setState(s);
            DESolver solver = maker.get();
            List<double[]> states = new ArrayList<>(List.of(s, s, s, s));
            try {
                for (int step = 0; step < steps; step++) {
                    source.step(solver, h);
                    states.add(0, source.getState());
                }
            } catch (RuntimeException e) {              // too long a step for it
                states.forEach(state -> Arrays.fill(state, Double.NaN));
            }
            return new Made(source, h, steps, states);
        }

        /** @return how far the step is off an equation; NaN without a step */
        double misfit(SolvedEquation known) {
            double[] s = states.get(1);
            double[] said = {};
            for (int j = 0; j < known.weights.length; j++) {
                int derivative = j - known.old();
                said = Combination.plus(said, known.weights[j], derivative < 0 ? states.get(1 + j) : rate(
                        Combination.plus(s, known.places[derivative], Combination.plus(states.get(0), -1, s)),
                        known.times[derivative]));
            }
            return Arrays.equals(s, states.get(0)) ? Double.NaN : SolverContract.distance(said, states.get(0));
        }

        private double[] rate(double[] at, double time) {
            source.setState(at);
            source.incTime(START + (steps - 1 + time) * h - source.getTime());
            double[] dSdt = new double[at.length];
            source.getStateDerivative(dSdt);
            return Combination.plus(new double[0], h, dSdt);
        }
    }
}
