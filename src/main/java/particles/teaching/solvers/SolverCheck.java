package particles.teaching.solvers;

import deSolvers.DESolver;
import deSolvers.FixedStepSolver;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.function.Supplier;
import particles.teaching.Finding;
import particles.teaching.StudentFailure;
import particles.teaching.contract.SolverContract;
import particles.teaching.sources.Springs;
import particles.teaching.sources.WindyOscillators;

/**
 * Checks a student's solver: identifies its method, and names one mistake, the first that explains the rest. It reads
 * the coefficients from a step. A method without fixed coefficients is judged by the equation that it solves, by the
 * weights of its later steps, or by its measured order.
 */
public final class SolverCheck {
    private static final double SHORT = 1.0 / 16;
    private static final double LONG = 8;
    private static final int LATER_STEPS = 6;
    /** Adaptive methods have an error that does not follow deltaT, and a small one. */
    private static final double SMALL_ERROR = 1e-4;
    /** Below this order the error does not go to 0; Euler measures 0.97 to 1.03. */
    private static final double LOWEST_ORDER = 0.7;

    private static final String MULTISTEP = "This is a method that uses earlier steps (a multistep method)";
    private static final String UNREAD = "This is a method without fixed coefficients, adaptive or implicit";

    private final Supplier<DESolver> maker;
    private final Optional<NamePromise> promise;
    private final ExplicitMethod explicit;
    private final UnreadMethod unread;
    private final List<Finding> findings = new ArrayList<>();
    private Optional<OrderMeasurement> measured = Optional.empty();
    private Optional<Finding> clock;

    private SolverCheck(Supplier<DESolver> maker, String className) {
        this.maker = maker;
        promise = NamePromise.of(className);
        explicit = new ExplicitMethod(maker, promise, () -> measurement().order());
        unread = new UnreadMethod(maker);
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
        return NamePromise.of(className).map(NamePromise::says).orElse("");
    }

    private SolverVerdict verdict() {
        String identity = "Its step cannot be judged yet.";
        boolean multistep = false;
        try {
            first().ifPresent(findings::add);
            if (findings.isEmpty()) {
                boolean remembers = remembers();
                multistep = remembers && unread.evaluations(1, SHORT) == unread.evaluations(1, LONG);
                identity = judge(remembers, multistep);
            }
        } catch (RuntimeException e) {
            findings.add(Phrase.EXCEPTION.of(StudentFailure.describe(e)));
        }
        String end = identity.endsWith(".") ? "" : isWrong() ? ", apart from the mistake below." : ".";
        return new SolverVerdict(identity + end, firstMistake(), multistep);
    }

    /** Whether it makes a step at all, and the same one each time. */
    private Optional<Finding> first() {
        WindyOscillators source = new WindyOscillators(2);
        WindyOscillators again = source.copy();
        double[] before = source.getState();
        DESolver solver = maker.get();
        solver.stepState(source, SHORT);
        Optional<Finding> none = Phrase.NOTHING_YET.when(Arrays.equals(before, source.getState()) && (solver
                instanceof FixedStepSolver || !source.isSet() && source.timeMoves() == 0)).or(() ->
                Phrase.NOT_FINITE.when(!Double.isFinite(Arrays.stream(source.getState()).sum())));
        if (none.isPresent()) {
            return none;
        }
        maker.get().stepState(again, SHORT);
        return Phrase.NOT_REPEATABLE.when(!Arrays.equals(again.getState(), source.getState()) || again.getTime()
                != source.getTime()).or(unread::mixed);
    }

    /** Finds mistakes, and the method. */
    private String judge(boolean remembers, boolean multistep) {
        clock = ClockCheck.mistake(maker).map(finding -> unread.rejectedClock().orElse(finding));
        Diagnosis diagnosis = remembers ? remembering(multistep)
                : explicit.diagnosis(1).or(this::equation).orElseGet(this::measured);
        findings.addAll(diagnosis.findings());
        clock.ifPresent(findings::add);
        if (!isWrong()) {
            promised(diagnosis, remembers).ifPresent(findings::add);
        }
        findings.addAll(SolverContract.check(maker, remembers, multistep));
        if (!isWrong()) {
            (remembers ? afterContract(multistep) : heldBy(diagnosis)).ifPresent(findings::add);
        }
        return diagnosis.identity();
    }

    private OrderMeasurement measurement() {
        if (measured.isEmpty()) {
            measured = Optional.of(OrderMeasurement.lowest(maker));
        }
        return measured.get();
    }

    /** Whether it is a method of the kind that its name says. */
    private Optional<Finding> promised(Diagnosis diagnosis, boolean remembers) {
        if (promise.isEmpty() && diagnosis.method().equals(KnownMethods.EULER)) {
            return Phrase.OLD_VELOCITY.when(SolverContract.isForParticles(maker));
        }
        return promise.flatMap(name -> name.remembers() && !remembers ? Optional.of(Phrase.NOTHING_EARLIER.of(
                name.says())) : name.adapts() && diagnosis.order() > 0 ? Optional.of(Phrase.NO_CONTROL.of())
                : diagnosis.method().isEmpty() ? Optional.empty() : name.contradicted(diagnosis.method(),
                diagnosis.order()));
    }

    private boolean isWrong() {
        return findings.stream().anyMatch(Finding::isWrong);
    }

    /** The first mistake, which explains the later ones, and the first notes on style. */
    private List<Finding> firstMistake() {
        Optional<Finding> first = findings.stream().filter(Finding::isWrong).findFirst();
        return findings.stream().filter(finding -> !finding.isWrong() || finding == first.get()).distinct().toList();
    }

    /** Whether a later step differs from the one that a new solver makes from the same place. */
    private boolean remembers() {
        DESolver solver = maker.get();
        WindyOscillators source = new WindyOscillators(2);
        for (int step = 0; step < LATER_STEPS; step++) {
            WindyOscillators twin = source.copy();
            maker.get().stepState(twin, SHORT);
            solver.stepState(source, SHORT);
            if (!(SolverContract.distance(twin.getState(), source.getState()) <= 1e-11)) {
                return true;
            }
        }
        return false;
    }

    /** The diagnosis of a method whose steps use results of earlier ones. */
    private Diagnosis remembering(boolean multistep) {
        WindyOscillators source = new WindyOscillators(1);
        DESolver solver = maker.get();
        solver.stepState(source, SHORT);
        long once = source.getEvaluations();
        solver.stepState(source, SHORT);
        boolean equation = SolvedEquation.of(maker, true, name -> true).filter(found -> found.mistake().isEmpty())
                .isPresent();
        return new Diagnosis(multistep || equation ? MULTISTEP : UNREAD, source.getEvaluations() == once ? Optional.of(
                Phrase.STALE.of()) : clock.isPresent() || !multistep ? clock : SolverContract.memory(maker, true,
                true).or(() -> measurement().order() > wanted(true) - 0.5 ? Optional.empty() : EarlierSteps.of(maker)
                .flatMap(EarlierSteps::wrongWeights)));
    }

    /**
     * Looks for mistakes of a method with memory that only the measured order shows, once its memory is known to be
     * reset in time.
     */
    private Optional<Finding> afterContract(boolean multistep) {
        Optional<Finding> begins = multistep ? EarlierSteps.of(maker).flatMap(reading -> reading.poorBeginning(
                measurement().order())) : Optional.empty();
        return begins.or(() -> poorOrder(multistep, () -> (multistep ? Optional.<Finding>empty() : firstSubStep(
                finding -> true)).or(() -> SolvedEquation.of(maker, true, name -> true).flatMap(
                SolvedEquation::mistake))));
    }

    /** The diagnosis of an implicit method whose equation is known. */
    private Optional<Diagnosis> equation() {
        Optional<SolvedEquation> found = SolvedEquation.of(maker, false, name -> promise.filter(words ->
                words.methods().contains(name)).isPresent()).filter(equation -> equation.isKnown() || equation.mistake()
                .isPresent());
        return found.map(equation -> equation.method().name()).or(() -> promise.filter(NamePromise::isImplicit)
                .flatMap(name -> name.methods().stream().findFirst())).map(name -> new Diagnosis("This is " + name,
                found.flatMap(SolvedEquation::mistake).or(unread::unstable).or(() -> SolvedEquation.loose(maker, name,
                unread.solvesWithMatrix() ? 0.5 : 3.0 / 32)).stream().toList(), 0, found.map(known -> name).orElse(
                "")));
    }

    /** The diagnosis of a method whose coefficients cannot be read. */
    private Diagnosis measured() {
        return new Diagnosis(UNREAD, clock.or(unread::entryByEntry)
                .or(() -> vanishes(measurement()) ? Optional.empty() : unread.rejectedClock())
                .or(() -> firstSubStep(finding -> finding.kind() != Finding.Kind.METHOD))
                .or(unread::uncut)
                .or(() -> poorOrder(false, () -> firstSubStep(finding -> true).or(unread::unstable)))
                .or(this::stageClocks).or(unread::uncontrolled).or(unread::asymmetric).or(unread::unstable));
    }

    /** A mistake in the first sub-step of an adaptive method, which it accepts where derivatives are tiny. */
    private Optional<Finding> firstSubStep(Predicate<Finding> which) {
        return explicit.diagnosis(StepReading.TINY).stream().flatMap(found -> found.findings().stream()).filter(
                which.and(Finding::isWrong)).findFirst();
    }

    private static boolean vanishes(OrderMeasurement measurement) {
        return measurement.order() >= LOWEST_ORDER || measurement.smallest()[1] < SMALL_ERROR;
    }

    /** Whether the measured order is that of the coefficients. */
    private Optional<Finding> heldBy(Diagnosis diagnosis) {
        int order = diagnosis.order();
        return order == 0 ? Optional.empty() : Phrase.OTHER_STEPS.when(measurement().order() < order - 0.5,
                ExplicitMethod.twoDigits(measurement().order()), order);
    }

    /** Whether the order falls where forces change with time. */
    private Optional<Finding> stageClocks() {
        double constant = OrderMeasurement.of(maker, Springs::new).order();
        double changing = OrderMeasurement.of(maker).order();
        return Phrase.STAGE_CLOCKS.when(constant > changing + 0.7, ExplicitMethod.twoDigits(changing),
                ExplicitMethod.twoDigits(constant));
    }

    /** The lowest order that the name allows; to use earlier steps without gaining order does not pay. */
    private int wanted(boolean multistep) {
        return Math.max(multistep ? 2 : 0, promise.map(NamePromise::order).orElse(0));
    }

    /** Whether the error goes to 0, and as fast as the class's name promises. */
    private Optional<Finding> poorOrder(boolean multistep, Supplier<Optional<Finding>> causes) {
        OrderMeasurement measurement = measurement();
        boolean vanishes = vanishes(measurement);
        double order = measurement.order();
        if (vanishes && (Double.isNaN(order) || order > wanted(multistep) - 0.5)) {
            return Optional.empty();
        }
        Optional<Finding> far = vanishes ? Optional.empty() : unread.elsewhere();
        return far.or(causes).or(() -> Optional.of(vanishes ? Phrase.NAME_ORDER.of(ExplicitMethod.twoDigits(order),
                promise.map(name -> "the name promises " + name.saysWithOrder()).orElse("a method that uses derivatives"
                + " of earlier steps has at least order 2")) : Phrase.NO_CONVERGENCE.of(measurement.smallest()[1],
                measurement.smallest()[0])));
    }
}
