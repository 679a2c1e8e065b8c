package particles.teaching.solvers;

import deSolvers.DESolver;
import deSolvers.FixedStepSolver;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import particles.teaching.Finding;
import particles.teaching.StudentFailure;
import particles.teaching.contract.ClockCheck;
import particles.teaching.contract.Phrase;
import particles.teaching.contract.SolverContract;
import particles.teaching.contract.SolverMemory;
import particles.teaching.sources.OrderMeasurement;
import particles.teaching.sources.StudentSource;
import particles.teaching.sources.WindyOscillators;

/**
 * Checks a student's solver: identifies its method, and names one mistake, the first that explains the rest. It reads
 * the coefficients from a step. A method without fixed coefficients is judged by the equation that it solves, by the
 * weights of its later steps, or by its measured order.
 */
public final class SolverCheck {
    private static final double SHORT = 1.0 / 16;
    /** A static memory of earlier derivatives shows once it is full. */
    private static final int REPEATED = 6;
    /** A step whose states and times belong together makes the same errors; Lawson's method makes 7 times as large. */
    private static final double OFF_CLOCK = 20;
    /** Smaller errors may be those of a tolerance; ten times that, those of coefficients with eight digits. */
    private static final double TOLERATED = 1e-8;

    private static final String MULTISTEP = "This is a method that uses earlier steps (a multistep method)";
    private static final String UNREAD = "This is a method without fixed coefficients, adaptive or implicit";

    private final Supplier<DESolver> maker;
    private final NamePromise promise;
    private final ExplicitMethod explicit;
    private final SolverContract contract;
    private final UnreadMethod unread;
    private final List<Finding> findings = new ArrayList<>();
    private Optional<OrderMeasurement> measured = Optional.empty();
    private Optional<Finding> clock;
    private SolverMemory memory;
    private String identity = "Its step cannot be judged yet.";
    private boolean multistep;

    private SolverCheck(Supplier<DESolver> maker, String className) {
        this.maker = maker;
        promise = NamePromise.of(className);
        explicit = new ExplicitMethod(maker, promise, this::measurement);
        contract = new SolverContract(maker);
        unread = new UnreadMethod(maker, contract);
    }

    /**
     * Checks a solver.
     *
     * @param maker     makes a new one
     * @param className the simple name of its class, which may promise a method, as HeunSolver does
     * @return its method, at most one mistake, and advice
     */
    public static SolverVerdict check(Supplier<DESolver> maker, String className) {
        return new SolverCheck(maker, className).verdict();
    }

    /** @return the method that a class's name promises, such as velocity Verlet; empty if it promises none */
    public static String promise(String className) {
        return NamePromise.of(className).says();
    }

    private SolverVerdict verdict() {
        try {
            start().ifPresentOrElse(findings::add, this::judge);
        } catch (RuntimeException e) {
            findings.add(Phrase.EXCEPTION.of(StudentFailure.describe(e)));
        }
        return new SolverVerdict(identity + (identity.endsWith(".") ? "" : isWrong() ? ", apart from the mistake below."
                : "."), firstMistake(), multistep);
    }

    /** Whether it makes a step at all, and the same one each time. */
    private Optional<Finding> start() {
        WindyOscillators source = new WindyOscillators(2);
        WindyOscillators again = source.copy();
        double[] before = source.getState();
        source.step(maker.get(), SHORT);
        boolean written = source.getEvaluations() > 1 || !(maker.get() instanceof FixedStepSolver) && (source.isSet()
                || source.timeMoves() > 0);
        return Phrase.NOTHING_YET.when(!written && Arrays.equals(before, source.getState())).or(() ->
                Phrase.NOT_FINITE.when(!Double.isFinite(Arrays.stream(source.getState()).sum()))).or(() ->
                Phrase.NOT_REPEATABLE.when(!IntStream.range(0, REPEATED).allMatch(time -> {
                    WindyOscillators twin = again.copy();
                    twin.step(maker.get(), SHORT);
                    return Arrays.equals(twin.getState(), source.getState()) && twin.getTime() == source.getTime();
                }))).or(() -> Search.first(contract::mixed, contract::adds));
    }

    /** Finds mistakes, and the method. */
    private void judge() {
        memory = SolverMemory.of(contract);
        multistep = memory.multistep();
        clock = ClockCheck.mistake(maker).map(finding -> unread.rejectedClock().orElse(finding)).or(() ->
                Search.first(contract::still));
        Diagnosis diagnosis = memory.remembers() ? remembering()
                : explicit.diagnosis(1).or(this::equation).orElseGet(this::measured);
        identity = diagnosis.identity();
        diagnosis.finding().ifPresent(findings::add);
        clock.ifPresent(findings::add);
        if (!isWrong()) {
            promised(diagnosis).ifPresent(findings::add);
        }
        findings.addAll(contract.check(memory));
        if (!isWrong()) {
            (memory.remembers() ? afterContract() : heldBy(diagnosis)).or(() -> promise.isSymmetric()
                    ? unread.irreversible(promise.says()) : Optional.empty()).ifPresent(findings::add);
        }
    }

    private OrderMeasurement measurement() {
        measured = measured.or(() -> Optional.of(OrderMeasurement.of(maker, () -> WindyOscillators.nonlinear(1))));
        return measured.get();
    }

    /** Whether it is a method of the kind that its name says. */
    private Optional<Finding> promised(Diagnosis diagnosis) {
        return Phrase.NO_CONTROL.when(promise.adapts() && diagnosis.order() > 0).or(() -> !promise.isGiven()
                ? Phrase.OLD_VELOCITY.when(diagnosis.method().equals(KnownMethods.EULER) && contract.isForParticles())
                : Phrase.NOTHING_EARLIER.when(promise.kind().equals("earlier") && !memory.remembers(), promise.says())
                .or(() -> promise.contradicted(diagnosis.method(), diagnosis.order())));
    }

    private boolean isWrong() {
        return findings.stream().anyMatch(Finding::isWrong);
    }

    /** The first mistake, which explains the later ones, and the first notes on style. */
    private List<Finding> firstMistake() {
        Optional<Finding> first = findings.stream().filter(Finding::isWrong).findFirst();
        return findings.stream().filter(finding -> !finding.isWrong() || finding == first.get()).distinct().toList();
    }

    /** The diagnosis of a method whose steps use results of earlier ones. */
    private Diagnosis remembering() {
        boolean equation = SolvedEquation.of(maker, true).filter(found -> found.wrong(promise).isEmpty()).isPresent();
        return new Diagnosis(multistep || equation ? MULTISTEP : UNREAD, Phrase.STALE.when(evaluations(1)
                == evaluations(2)));
    }

    private long evaluations(int steps) {
        return StudentSource.after(new WindyOscillators(1), maker.get(), steps, SHORT).getEvaluations();
    }

    /**
     * Looks for mistakes of a method with memory that only the measured order shows, once its memory is known to be
     * reset in time.
     */
    private Optional<Finding> afterContract() {
        return stageClocks().or(() -> !multistep ? Optional.empty() : SolvedEquation.ofEarlierSteps(
                maker).flatMap(reading -> reading.wrongWeights(measurement(), wanted())))
                .or(() -> poorOrder(() -> SolvedEquation.of(maker, true).flatMap(found -> found.wrong(promise)).or(() ->
                Phrase.START.when(unread.firstOrder() < measurement().order() + 0.5, wanted(), measurement().digits(),
                wanted() - 1))));
    }

    /** The diagnosis of an implicit method whose equation is known. */
    private Optional<Diagnosis> equation() {
        Optional<SolvedEquation> found = SolvedEquation.of(maker, false);
        return found.map(SolvedEquation::name).or(() -> Optional.of(promise.says()).filter(name ->
                promise.isImplicit() && KnownMethods.IMPLICIT.contains(name))).or(() -> unread.makesSubSteps()
                ? Optional.empty() : SolvedEquation.near(maker)).map(name -> new Diagnosis("This is " + name,
                Search.first(() -> found.flatMap(one -> one.wrong(promise)), this::unstable, contract::asymmetric, () ->
                SolvedEquation.loose(maker, name, contract.solvesWithMatrix())), 0, found.isPresent() ? name : ""));
    }

    /** The diagnosis of a method whose coefficients cannot be read. */
    private Diagnosis measured() {
        return new Diagnosis(UNREAD, clock.or(() -> Search.first(unread::entryByEntry, () -> firstSubStep(finding ->
                finding.kind() != Finding.Kind.METHOD), contract::asymmetric, this::stageClocks, unread::uncut, () ->
                unread.stages(promise, measurement().order()), () -> poorOrder(this::unstable), unread::elsewhere,
                unread::uncontrolled, () ->
                promise.kind().equals("implicit") || measurement().order() < UnreadMethod.SECOND ? unstable()
                : Optional.empty(), explicit::dragged)));
    }

    private Optional<Finding> unstable() {
        return unread.unstable(measurement().order());
    }

    /** A mistake in the first sub-step of an adaptive method, which it accepts where derivatives are tiny. */
    private Optional<Finding> firstSubStep(Predicate<Finding> which) {
        return !unread.makesSubSteps() ? Optional.empty() : explicit.diagnosis(SolverContract.TINY).flatMap(
                Diagnosis::finding).filter(which.and(Finding::isWrong));
    }

    /** Whether the measured order is that of the coefficients. */
    private Optional<Finding> heldBy(Diagnosis diagnosis) {
        return diagnosis.order() == 0 ? Optional.empty() : Phrase.OTHER_STEPS.when(measurement().order()
                < diagnosis.order() - 0.5 && measurement().smallest()[1] > 10 * TOLERATED, measurement().digits(),
                diagnosis.order());
    }

    /** Whether the law that is read off the clock leads astray, and the same law without a clock does not. */
    private Optional<Finding> stageClocks() {
        Iterator<double[]> timeless = OrderMeasurement.of(maker, WindyOscillators::timeless).points().iterator();
        for (double[] point : measurement().points()) {
            double error = point[1];
            double without = timeless.hasNext() ? timeless.next()[1] : error;
            if (error > OFF_CLOCK * without && error > TOLERATED && Double.isFinite(error)) {
                return unread.rejectedClock().or(() -> Optional.of(Phrase.STAGE_CLOCKS.of(error, point[0], without)));
            }
        }
        return Optional.empty();
    }

    /** The lowest order that the name allows; to use earlier steps without gaining order does not pay. */
    private int wanted() {
        return Math.max(multistep ? 2 : 0, promise.order());
    }

    /**
     * Whether the error goes to 0, and as fast as the class's name promises. Below the lowest order that is one, a
     * small error is that of a tolerance, whatever deltaT is.
     */
    private Optional<Finding> poorOrder(Search cause) {
        OrderMeasurement order = measurement();
        boolean far = order.isFar();
        return !far && !(order.order() >= OrderMeasurement.LOWEST && order.order() <= wanted() - 0.5) ? Optional.empty()
                : Search.first(() -> far ? unread.elsewhere() : Optional.empty(), () -> firstSubStep(finding ->
                true), cause, () ->
                Phrase.NO_CONVERGENCE.when(far, order.smallest()[1], order.smallest()[0]), () ->
                Optional.of(Phrase.NAME_ORDER.of(order.digits(), promise.isGiven()
                ? promise.saysWithOrder(promise.order())
                : "a method that uses derivatives of earlier steps has at least order 2")));
    }
}
