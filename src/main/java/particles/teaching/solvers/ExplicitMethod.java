package particles.teaching.solvers;

import deSolvers.DESolver;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.teaching.Finding;
import particles.teaching.Formula;
import particles.teaching.StudentFailure;
import particles.teaching.sources.Probe;
import particles.teaching.sources.Springs;
import particles.teaching.sources.StiffDecay;
import particles.teaching.sources.StudentSource;

/**
 * Identifies a method whose step is a combination with fixed weights, and its mistakes: first those that all methods
 * can have, then the difference from the nearest known method.
 */
final class ExplicitMethod {
    /** No power of 2, so that a deltaT in float arithmetic shows. */
    private static final double H = 0.2;
    /** Up to this number of evaluations a method should have full order; one with more may aim at stability instead. */
    private static final int MANY = 4;
    private static final double ALMOST = 0.3;

    private final Supplier<DESolver> maker;
    private final NamePromise promise;
    private final Supplier<OrderMeasurement> measured;
    private final List<Finding> findings = new ArrayList<>();
    private StepReading step;
    private int order;
    private String method = "";

    ExplicitMethod(Supplier<DESolver> maker, NamePromise promise, Supplier<OrderMeasurement> measured) {
        this.maker = maker;
        this.promise = promise;
        this.measured = measured;
    }

    /**
     * @param size the size of the derivatives in the reading: 1, or so small that an adaptive method accepts its first
     *             step
     * @return the diagnosis; empty if its steps have no fixed coefficients
     */
    Optional<Diagnosis> diagnosis(double size) {
        findings.clear();
        Optional<StepReading> once = StepReading.of(maker, H, size, 1);
        Optional<StepReading> twice = StepReading.of(maker, 2 * H, size, 1);
        Optional<StepReading> back = StepReading.of(maker, -H, size, 1).filter(reading -> reading.evaluations() > 0);
        if (once.isEmpty() || twice.isEmpty() || Stream.concat(twice.stream(), back.stream()).anyMatch(other ->
                other.evaluations() != once.get().evaluations())) {
            return Optional.empty();
        }
        step = once.get();
        if (size == 1 && step.isStill() && StepReading.of(maker, H, StepReading.TINY, 1).stream()
                .noneMatch(StepReading::isStill)) {
            return Optional.of(new Diagnosis("This is a method with step-size control", Optional.of(
                    Phrase.REJECTED_CLOCK.of())));
        }
        StepRules rules = new StepRules(step, twice.get(), back, findings::add);
        step.calls().wrongLengths().stream().limit(1).forEach(length -> findings.add(Phrase.ARRAY_LENGTH.of(length)));
        findings.addAll(step.findings());
        if (step.evaluations() == 0) {
            return Optional.of(new Diagnosis("It makes no step.", Stream.concat(findings.stream(), Stream.of(
                    Phrase.NO_DERIVATIVE.of())).findFirst()));
        }
        oddSize().filter(finding -> !step.scheme().isOfParticles()).ifPresent(findings::add);
        Scheme scheme = step.scheme().isOfParticles() ? step.scheme().withoutUnused() : step.scheme();
        boolean end = rules.checkState(scheme) && rules.checkDeltaT();
        String identity = identity(scheme, end);
        return Optional.of(new Diagnosis(identity, List.copyOf(findings), order, method));
    }

    /** A method with one formula for all entries can step a state of any size. */
    private Optional<Finding> oddSize() {
        try {
            maker.get().stepState(new Probe(new double[3], 0, (evaluation, dSdt) -> dSdt[0] = StepReading.TINY,
                    Probe.MOST_EVALUATIONS), H);
            return Optional.empty();
        } catch (RuntimeException e) {
            return Phrase.ODD_SIZE.when(!StudentFailure.isRefusal(e), StudentFailure.describe(e));
        }
    }

    private boolean isWrong() {
        return findings.stream().anyMatch(Finding::isWrong);
    }

    /** The method in a sentence; adds what differs from it. */
    private String identity(Scheme read, boolean end) {
        boolean clock = step.isOnTime();
        boolean waste = end && !read.isOfParticles() && read.ends().get(0).increment() != 0
                && !KnownMethods.isStagesOfAny(read);
        Scheme scheme = waste ? read.withoutUnused() : read;
        if (scheme.size() < read.size()) {
            findings.add(Phrase.UNUSED.of());
        }
        List<Scheme> like = KnownMethods.like(scheme);
        Comparison nearest = Comparison.nearest(like, scheme, step);
        if (nearest.first().isEmpty()) {
            order = nearest.known().order();
            method = end && clock ? nearest.known().name() : "";
            return "This is " + nearest.known().name();
        }
        List<Scheme> meant = like.stream().filter(known -> promise.isGiven() && promise.allows(known.name(),
                known.order())).toList();
        Comparison named = meant.isEmpty() ? nearest : Comparison.nearest(meant, scheme, step);
        if (!end || !clock) {
            named.first().filter(finding -> end && scheme.isInTurn() && named.isNear()).ifPresent(findings::add);
            return "This is nearest to " + named.known().name();
        }
        Optional<Finding> unsolved = SolvedEquation.rounds(maker, scheme, promise).or(() -> KnownMethods.mistake(
                scheme)).or(() -> Phrase.EXPLICIT.when(promise.isImplicit(), "an explicit method with "
                + count(scheme), promise.says()));
        if (unsolved.isPresent()) {
            findings.add(0, unsolved.get());
            return "This is an explicit method";
        }
        return unknown(scheme, named);
    }

    private static String count(Scheme scheme) {
        return scheme.size() + (scheme.isOfParticles() ? " acceleration" : " evaluation") + (scheme.size() == 1 ? ""
                : "s") + " per step";
    }

    /** Judges coefficients that are those of no known method by their measured order, and by the nearest one. */
    private String unknown(Scheme scheme, Comparison nearest) {
        boolean particles = scheme.isOfParticles();
        OrderMeasurement full = measured.get();
        int wanted = promise.isGiven() ? promise.order() : nearest.isNear() ? nearest.known().order() : 1;
        order = (int) Math.max(0, Math.round(full.order()));     // 0 for NaN
        boolean keepsArea = particles && Math.abs(StudentSource.after(new Springs(), maker.get(), 1, 1).steps()
                .determinant() - 1) < 1e-10;
        boolean pays = full.order() > 1.7 || full.order() > 1 - ALMOST && (particles ? keepsArea : isStableBeyondEuler(
                scheme));
        if (!nearest.isRounded() && (!particles || !isWrong()) && full.order() >= wanted - ALMOST && pays) {
            return "This is a " + (particles ? "method of order " + order + " that moves positions and velocities in"
                    + " turn," + (keepsArea ? " symplectic," : "") : "Runge-Kutta method of order " + order) + " with "
                    + count(scheme) + "; its coefficients match no named method";
        }
        boolean near = nearest.isNear() || promise.isWhole() && nearest.known().size() == scheme.size() && (particles
                || scheme.size() <= MANY);
        Combination row = scheme.ends().get(0);
        Search.first(() -> nearest.first().filter(finding -> near), () -> IntStream.range(0, particles ? 0
                : scheme.size()).mapToObj(i -> offTime(scheme.stages().get(i), scheme.times()[i])).flatMap(
                Optional::stream).findFirst(), () -> Phrase.WEIGHTS_SUM.when(!particles && !Formula.same(
                row.increment(), 1), row.increment()), () -> Optional.of(Phrase.LOW_ORDER.of(full.digits(), count(
                scheme), promise.isGiven() ? "; " + promise.saysWithOrder() : "", row.what(), row.formula())))
                .ifPresent(findings::add);
        return near ? "This is nearest to " + nearest.known().name() : "This is a method of your own";
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
