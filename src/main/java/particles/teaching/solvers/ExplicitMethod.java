package particles.teaching.solvers;

import deSolvers.DESolver;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.teaching.Finding;
import particles.teaching.Formula;
import particles.teaching.contract.Phrase;
import particles.teaching.contract.SolverContract;
import particles.teaching.sources.OrderMeasurement;
import particles.teaching.sources.Probe;
import particles.teaching.sources.Springs;
import particles.teaching.sources.StiffDecay;
import particles.teaching.sources.StudentSource;
import particles.teaching.sources.WindyOscillators;

/**
 * Identifies a method whose step is a combination with fixed weights, and its mistakes: first those that all methods
 * can have, then the difference from the nearest known method.
 *
 * @param maker    makes a new solver
 * @param promise  of its name
 * @param measured measures its order
 */
record ExplicitMethod(Supplier<DESolver> maker, NamePromise promise, Supplier<OrderMeasurement> measured) {
    /** No power of 2, so that a deltaT in float arithmetic shows. */
    private static final double H = 0.2;
    /** Up to this number of evaluations a method should have full order; one with more may aim at stability instead. */
    private static final int MANY = 4;
    /** Four results of Gragg's method take 24 evaluations; no other method is read so far. */
    private static final int MORE = 8;
    private static final double ALMOST = 0.3;

    /**
     * @param size the size of the derivatives in the reading: 1, or so small that an adaptive method accepts its first
     *             step
     * @return the diagnosis; empty if its steps have no fixed coefficients
     */
    Optional<Diagnosis> diagnosis(double size) {
        int most = Probe.MOST_EVALUATIONS + (promise.extrapolates() ? MORE : 0);
        Optional<StepReading> once = StepReading.of(maker, H, size, 1, most, false);
        Optional<StepReading> twice = StepReading.of(maker, 2 * H, size, 1, most, false);
        Optional<StepReading> back = StepReading.of(maker, -H, size, 1, most, false).filter(reading ->
                reading.evaluations() > 0);
        if (once.isEmpty() || twice.isEmpty() || Stream.concat(twice.stream(), back.stream()).anyMatch(other ->
                other.evaluations() != once.get().evaluations())) {
            return Optional.empty();
        }
        boolean rejects = size == 1 && once.get().isStill() && StepReading.of(maker, H, SolverContract.TINY, 1, most,
                false).stream().noneMatch(StepReading::isStill);
        return Optional.of(rejects ? new Diagnosis("This is a method with step-size control", Optional.of(
                Phrase.REJECTED_CLOCK.of())) : diagnosis(once.get(), new StepRules(once.get(), twice.get(), back)));
    }

    private Diagnosis diagnosis(StepReading step, StepRules rules) {
        Scheme read = step.scheme();
        boolean still = step.evaluations() == 0;
        Optional<Finding> rule = Search.first(() -> step.calls().wrongLength().map(Phrase.ARRAY_LENGTH::of), () ->
                step.findings().stream().findFirst(), () -> Phrase.NO_DERIVATIVE.when(still), rules::notSet,
                rules::oldState, () -> rules.deltaT().map(finding -> promise.isImplicit() && read.size() > 1
                ? unsolved(read) : finding));
        if (still) {
            return new Diagnosis("It makes no step.", rule);
        }
        Scheme scheme = read.isOfParticles() || rule.isEmpty() && read.ends().get(0).increment() != 0
                && !KnownMethods.isAny(read, 0) ? read.withoutUnused() : read;
        List<Scheme> like = KnownMethods.like(scheme);
        List<Scheme> meant = like.stream().filter(known -> promise.isGiven() && promise.allows(known.name(),
                known.order())).toList();
        Comparison any = Comparison.nearest(like, scheme, step);
        Comparison nearest = any.first().isEmpty() || meant.isEmpty() ? any : Comparison.nearest(meant, scheme, step);
        String name = nearest.known().name();
        boolean same = nearest.first().isEmpty();
        if (rule.isPresent() || !step.isOnTime()) {     // the clock may follow the drifts
            return new Diagnosis("This is " + (same ? "" : "nearest to ") + name, rule.or(() -> nearest.first().filter(
                    finding -> scheme.isInTurn() && nearest.isNear())));
        }
        boolean idle = scheme.size() < read.size();
        Optional<Finding> note = (read.isOfParticles() ? dragged() : Phrase.UNUSED.when(idle)).or(() ->
                Phrase.PRINTED.when(same && scheme.size() > 1 && !KnownMethods.isAny(scheme, 1), name));
        Optional<Finding> unsolved = same ? note : SolvedEquation.rounds(maker, scheme, promise).or(() ->
                KnownMethods.mistake(scheme)).or(() -> Optional.of(idle && read.stages().stream().allMatch(
                stage -> stage.increment() == 0) ? Phrase.NOT_ITERATED.of(promise.says())
                : unsolved(scheme)).filter(finding -> promise.isImplicit()));
        return same ? new Diagnosis("This is " + name, note, nearest.known().order(), name)
                : unsolved.isPresent() ? new Diagnosis("This is an explicit method", unsolved)
                : unknown(scheme, nearest, note);
    }

    /** @return the mistake or note of a method whose order falls where the acceleration depends on the velocity. */
    Optional<Finding> dragged() {
        OrderMeasurement drag = OrderMeasurement.of(maker, WindyOscillators::withDrag);
        return Phrase.DRAG_DIVERGES.when(drag.isFar(), drag.digits()).or(() ->
                Phrase.DRAG.when(drag.order() < measured.get().order() - 0.7, measured.get().digits(), drag.digits()));
    }

    private Finding unsolved(Scheme scheme) {
        return Phrase.EXPLICIT.of("an explicit method with " + count(scheme), promise.says());
    }

    private static String count(Scheme scheme) {
        return scheme.size() + (scheme.isOfParticles() ? " acceleration" : " evaluation") + (scheme.size() == 1 ? ""
                : "s") + " per step";
    }

    /** Judges coefficients that are those of no known method by their measured order, and by the nearest one. */
    private Diagnosis unknown(Scheme scheme, Comparison nearest, Optional<Finding> note) {
        boolean particles = scheme.isOfParticles();
        OrderMeasurement full = measured.get();
        long results = scheme.stages().stream().filter(stage -> stage.increment() == 0).count();
        int wanted = Math.max(promise.order((int) results), nearest.isNear() ? nearest.known().order() : 1);
        int order = (int) Math.max(0, Math.round(full.order()));     // 0 for NaN
        boolean keepsArea = particles && Math.abs(StudentSource.after(new Springs(), maker.get(), 1, 1).steps()
                .determinant() - 1) < 1e-10;
        boolean pays = full.order() > 1.7 || full.order() > 1 - ALMOST && (particles ? keepsArea : isStableBeyondEuler(
                scheme));
        if (!nearest.isRounded() && full.order() >= wanted - ALMOST && pays) {
            return new Diagnosis("This is a " + (particles ? "method of order " + order + " that moves positions and"
                    + " velocities in turn," + (keepsArea ? " symplectic," : "") : "Runge-Kutta method of order "
                    + order) + " with " + count(scheme) + "; its coefficients match no named method",
                    note, order, "");
        }
        boolean near = nearest.isNear() || !promise.changed() && nearest.known().size() == scheme.size() && (particles
                || scheme.size() <= MANY);
        Combination row = scheme.ends().get(0);
        return new Diagnosis(near ? "This is nearest to " + nearest.known().name() : "This is a method of your own",
                Search.first(() -> nearest.first().filter(finding -> near), () -> IntStream.range(0,
                particles ? 0 : scheme.size()).mapToObj(i -> offTime(scheme.stages().get(i), scheme.times()[i]))
                .flatMap(Optional::stream).findFirst(), () -> Phrase.WEIGHTS_SUM.when(!particles && !Formula.same(
                row.increment(), 1), row.increment()), () ->
                IntStream.range(1, particles ? 0 : wanted).filter(power -> !Formula.same(scheme.moment(power), 1.0
                / (power + 1))).mapToObj(power -> Phrase.MOMENT.of(full.digits(),
                promise.saysWithOrder(wanted), row.formula(), power, 1.0 / (power + 1), scheme.moment(power)))
                .findFirst(),
                () -> Optional.of(Phrase.LOW_ORDER.of(full.digits(), count(
                scheme), promise.isGiven() ? "; " + promise.saysWithOrder(wanted) : "", row.what(), row.formula()))));
    }

    private static Optional<Finding> offTime(Combination stage, double time) {
        return Phrase.TIME_OF_STAGE.when(!Formula.same(stage.increment(), time), stage.what(), stage.formula(),
                Formula.time(time), Formula.time(stage.increment()));
    }

    /** On the negative real axis s Euler steps are stable to 2 s; a method of order 1 has to do as well to pay. */
    private boolean isStableBeyondEuler(Scheme scheme) {
        return IntStream.range(1, 16 * scheme.size()).allMatch(z -> StudentSource.after(new StiffDecay(),
                maker.get(), 1, z / 8.0 / StiffDecay.RATE).size() <= 1 + 1e-9);
    }
}
