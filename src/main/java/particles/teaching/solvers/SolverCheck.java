package particles.teaching.solvers;

import deSolvers.DESolver;
import deSolvers.FixedStepSolver;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import particles.teaching.Finding;
import particles.teaching.Formula;
import particles.teaching.StudentFailure;
import particles.teaching.contract.SolverContract;
import particles.teaching.sources.NonlinearOscillators;
import particles.teaching.sources.StudentSource;
import particles.teaching.sources.WindyOscillators;

/**
 * Checks a student's solver: identifies its method, and names one mistake, the first that explains the rest. It reads
 * the coefficients from a step. A method without fixed coefficients is judged by the equation that it solves, by the
 * weights of its later steps, or by its measured order.
 */
public final class SolverCheck {
    private static final double H = 1.0 / 4;
    private static final double SHORT = 1.0 / 16;
    /** No power of 2, so that a clock in float arithmetic shows. */
    private static final double TENTH = 0.1;
    private static final double ROUNDING = 1e-13;
    private static final int LATER_STEPS = 6;
    /** Adaptive methods have an error that does not follow deltaT, and a small one. */
    private static final double SMALL_ERROR = 1e-4;
    /** Below this order the error does not go to 0; Euler measures 0.97 to 1.03. */
    private static final double LOWEST_ORDER = 0.7;

    private static final String MULTISTEP = "This is a method that uses earlier steps (a multistep method).";
    private static final String UNREAD = "This is a method without fixed coefficients, adaptive or implicit.";

    private final Supplier<DESolver> maker;
    private final Optional<NamePromise> promise;
    private final ExplicitMethod explicit;
    private final UnreadMethod unread;
    private final List<Finding> findings = new ArrayList<>();
    private Optional<OrderMeasurement> measured = Optional.empty();

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

    private SolverVerdict verdict() {
        try {
            WindyOscillators source = new WindyOscillators(2);
            double[] before = source.getState();
            DESolver solver = maker.get();
            solver.stepState(source, SHORT);
            if (Arrays.equals(before, source.getState()) && (solver instanceof FixedStepSolver || !source.isSet()
                    && source.timeMoves() == 0)) {
                return stopped("It makes no step.", Phrase.NOTHING_YET.of());
            }
            if (!Double.isFinite(Arrays.stream(source.getState()).sum())) {
                return stopped("It makes no step.", Phrase.NOT_FINITE.of());
            }
        } catch (RuntimeException e) {
            return stopped("It makes no step.", Phrase.EXCEPTION.of(StudentFailure.describe(e)));
        }
        if (!repeats()) {
            return stopped("It makes another step each time.", Phrase.NOT_REPEATABLE.of());
        }
        boolean remembers = remembers();
        boolean multistep = remembers && evaluations(SHORT) == evaluations(8);
        String identity = "It makes a step, and fails in others.";
        try {
            Diagnosis diagnosis = remembers ? remembering(multistep)
                    : explicit.diagnosis(1).or(this::equation).orElseGet(this::measured);
            identity = diagnosis.identity();
            findings.addAll(diagnosis.findings());
            if (!isWrong()) {
                promised(diagnosis, remembers).ifPresent(findings::add);
            }
            findings.addAll(SolverContract.check(maker, remembers, multistep));
            if (!isWrong()) {
                clock().or(() -> remembers ? afterContract(multistep) : heldBy(diagnosis)).ifPresent(findings::add);
            }
        } catch (RuntimeException e) {
            findings.add(Phrase.EXCEPTION.of(StudentFailure.describe(e)));
        }
        return new SolverVerdict(identity, firstMistake(), identity.equals(MULTISTEP));
    }

    private OrderMeasurement measurement() {
        if (measured.isEmpty()) {
            measured = Optional.of(OrderMeasurement.lowest(maker));
        }
        return measured.get();
    }

    /** Whether it is a method of the kind that its name says. */
    private Optional<Finding> promised(Diagnosis diagnosis, boolean remembers) {
        return promise.filter(name -> name.remembers() && !remembers).map(name -> Phrase.NOTHING_EARLIER.of(
                name.says())).or(() -> promise.filter(name -> name.adapts() && diagnosis.order() > 0).map(name ->
                Phrase.NO_CONTROL.of()));
    }

    private static SolverVerdict stopped(String identity, Finding finding) {
        return new SolverVerdict(identity, List.of(finding), false);
    }

    private boolean isWrong() {
        return findings.stream().anyMatch(Finding::isWrong);
    }

    /** The first mistake, which explains the later ones, and the first notes on style. */
    private List<Finding> firstMistake() {
        Optional<Finding> first = findings.stream().filter(Finding::isWrong).findFirst();
        return findings.stream().filter(finding -> !finding.isWrong() || finding == first.get()).distinct().toList();
    }

    private boolean repeats() {
        WindyOscillators one = new WindyOscillators(2);
        WindyOscillators two = one.copy();
        maker.get().stepState(one, SHORT);
        maker.get().stepState(two, SHORT);
        return Arrays.equals(one.getState(), two.getState()) && one.getTime() == two.getTime();
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
        List<Finding> found = new ArrayList<>();
        WindyOscillators source = new WindyOscillators(1);
        DESolver solver = maker.get();
        solver.stepState(source, SHORT);
        long once = source.getEvaluations();
        solver.stepState(source, SHORT);
        if (source.getEvaluations() == once) {
            found.add(Phrase.STALE.of());
        }
        clock().ifPresent(found::add);
        if (multistep && found.isEmpty()) {
            SolverContract.memory(maker, true, true).or(() -> EarlierSteps.of(maker).flatMap(
                    EarlierSteps::wrongWeights)).ifPresent(found::add);
        }
        boolean equation = SolvedEquation.of(maker, true, name -> true).filter(SolvedEquation::isRight).isPresent();
        return new Diagnosis(multistep || equation ? MULTISTEP : UNREAD, found);
    }

    /**
     * Looks for mistakes of a method with memory that only the measured order shows, once its memory is known to be
     * reset in time.
     */
    private Optional<Finding> afterContract(boolean multistep) {
        Optional<Finding> begins = multistep ? EarlierSteps.of(maker).flatMap(reading -> reading.poorBeginning(
                measurement().order())) : Optional.empty();
        return begins.or(() -> poorOrder(() -> UnreadMethod.firstSubStep(explicit, finding -> true)
                .or(() -> SolvedEquation.of(maker, true, name -> true).flatMap(SolvedEquation::mistake))));
    }

    /** The diagnosis of an implicit method whose equation is known. */
    private Optional<Diagnosis> equation() {
        Optional<SolvedEquation> found = SolvedEquation.of(maker, false, name ->
                promise.filter(words -> words.methods().contains(name)).isPresent());
        Optional<String> meant = found.filter(equation -> equation.isKnown() || equation.mistake().isPresent()).map(
                SolvedEquation::name).or(() -> promise.filter(NamePromise::isImplicit).map(name -> name.methods().get(
                0)));
        return meant.map(name -> {
            Optional<Finding> other = promise.filter(words -> words.isWhole() && !words.allows(name, 0)
                    && found.filter(SolvedEquation::isKnown).isPresent()).map(words -> Phrase.CONTRADICTS.of(name,
                    words.says()));
            Optional<Finding> mistake = other.or(() -> found.flatMap(SolvedEquation::mistake)).or(unread::unstable)
                    .or(() -> SolvedEquation.loose(maker, name, unread.solvesWithMatrix() ? 0.5 : 3.0 / 32));
            return new Diagnosis("This is " + name + (mistake.isEmpty() ? "." : ", apart from the mistake below."),
                    mistake.stream().toList());
        });
    }

    /** The diagnosis of a method whose coefficients cannot be read. */
    private Diagnosis measured() {
        return new Diagnosis(UNREAD, clock()
                .or(unread::entryByEntry)
                .or(() -> vanishes(measurement()) ? Optional.empty() : unread.rejectedClock())
                .or(() -> UnreadMethod.firstSubStep(explicit, finding -> finding.kind() != Finding.Kind.METHOD))
                .or(this::layout)
                .or(() -> poorOrder(() -> UnreadMethod.firstSubStep(explicit, finding -> true).or(unread::unstable)))
                .or(unread::uncontrolled).or(unread::asymmetric).or(unread::unstable).stream().toList());
    }

    private static boolean vanishes(OrderMeasurement measurement) {
        return measurement.order() >= LOWEST_ORDER || measurement.smallest()[1] < SMALL_ERROR;
    }

    /** Whether the measured order is that of the coefficients. */
    private Optional<Finding> heldBy(Diagnosis diagnosis) {
        double order = diagnosis.order() == 0 ? Double.NaN : measurement().order();
        return order < diagnosis.order() - 0.5 ? Optional.of(Phrase.OTHER_STEPS.of(ExplicitMethod.twoDigits(order),
                diagnosis.order())) : Optional.empty();
    }

    /** Whether only one particle is moved as it should be. */
    private Optional<Finding> layout() {
        return measurement().order() >= LOWEST_ORDER && !vanishes(OrderMeasurement.of(maker, () ->
                new WindyOscillators(2))) ? Optional.of(Phrase.LAYOUT.of()) : Optional.empty();
    }

    /** Whether the error goes to 0, and as fast as the class's name promises. */
    private Optional<Finding> poorOrder(Supplier<Optional<Finding>> causes) {
        OrderMeasurement measurement = measurement();
        boolean vanishes = vanishes(measurement);
        double order = measurement.order();
        if (vanishes && (Double.isNaN(order) || promise.isEmpty() || order > promise.get().order() - 0.5)) {
            return Optional.empty();
        }
        Optional<Finding> far = vanishes ? Optional.empty() : unread.elsewhere();
        return far.or(causes).or(() -> Optional.of(vanishes ? Phrase.NAME_ORDER.of(ExplicitMethod.twoDigits(order),
                promise.get().saysWithOrder()) : Phrase.NO_CONVERGENCE.of(measurement.smallest()[1],
                measurement.smallest()[0])));
    }

    /** Whether the clock ends where the step does, also in later steps. */
    private Optional<Finding> clock() {
        for (double h : new double[] {H, TENTH}) {
            WindyOscillators source = new WindyOscillators(1);
            DESolver solver = maker.get();
            for (int step = 0; step < LATER_STEPS; step++) {
                double start = source.getTime();
                solver.stepState(source, h);
                double end = (source.getTime() - start) / h;
                if (Math.abs(end - 1) > (step == 0 ? ROUNDING : LATER_STEPS * ROUNDING)) {
                    String when = step == 0 ? "" : "from step " + (step + 1) + " on ";
                    return Optional.of(end == 0 ? Phrase.CLOCK_STILL.of(when) : Phrase.CLOCK_LATER.of(when,
                            Formula.time(end), h, why(source, h, end)));
                }
            }
        }
        return Optional.empty();
    }

    private static String why(StudentSource source, double h, double end) {
        return end > 1 && source.error() < SMALL_ERROR ? ", and the state is where the clock is: the last sub-step"
                + " has to be cut to what is left of deltaT" : "";
    }

    private long evaluations(double deltaT) {
        NonlinearOscillators source = new NonlinearOscillators(1);
        try {
            maker.get().stepState(source, deltaT);
        } catch (RuntimeException e) {
            return -1;                                  // too long for it, which a multistep method would not notice
        }
        return source.getEvaluations();
    }
}
