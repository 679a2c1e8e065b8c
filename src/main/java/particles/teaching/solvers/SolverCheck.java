package particles.teaching.solvers;

import deSolvers.DESolver;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.function.Supplier;
import particles.teaching.Finding;
import particles.teaching.Finding.Kind;
import particles.teaching.Formula;
import particles.teaching.StudentFailure;
import particles.teaching.contract.SolverContract;
import particles.teaching.sources.NonlinearOscillators;
import particles.teaching.sources.Springs;
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
    private static final double KICKS_ROUNDING = 1e-12;
    private static final double SMALL_ERROR = 1e-4;

    private static final String MULTISTEP = "This is a method that uses earlier steps (a multistep method).";
    private static final String UNREAD = "This is a method without fixed coefficients, adaptive or implicit.";

    private final Supplier<DESolver> maker;
    private final Optional<NamePromise> promise;
    private final AccuracyCheck accuracy;
    private final List<Finding> findings = new ArrayList<>();

    private SolverCheck(Supplier<DESolver> maker, String className) {
        this.maker = maker;
        promise = NamePromise.of(className);
        accuracy = new AccuracyCheck(maker, promise);
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
            maker.get().stepState(source, SHORT);
            if (!Double.isFinite(Arrays.stream(source.state()).sum())) {
                return stopped("It makes no step.", Kind.STATE, "the new state is NaN or infinite although state and "
                        + "derivative"
                        + " are finite: look for 0/0, the root of a negative number, a division by something that is 0,"
                        + " or a matrix with a row of zeros");
            }
        } catch (RuntimeException e) {
            return stopped("It makes no step.", Kind.FAILURE, "stepState ends in an exception: "
                    + StudentFailure.describe(e));
        }
        if (!repeats()) {
            return stopped("It makes another step each time.", Kind.METHOD,
                    "two new solvers make different steps from the same"
                    + " place: something is random, or static and shared by all solvers (a static field outlives a "
                    + "step and its"
                    + " solver)");
        }
        boolean remembers = remembers();
        boolean multistep = remembers && evaluations(SHORT) == evaluations(8);
        String identity = "It makes a step, and fails in others.";
        try {
            Diagnosis diagnosis = remembers ? remembering(multistep)
                    : tableau(1).or(this::kicks).or(() -> ImplicitFormula.of(maker, promise)).orElseGet(this::measured);
            identity = diagnosis.identity();
            findings.addAll(diagnosis.findings());
            if (!isWrong()) {
                promised(diagnosis, remembers).ifPresent(findings::add);
            }
            findings.addAll(SolverContract.check(maker, remembers, multistep));
            if (!isWrong()) {
                clock().or(() -> remembers ? afterContract(multistep) : accuracy.held(diagnosis))
                        .ifPresent(findings::add);
            }
        } catch (RuntimeException e) {
            findings.add(new Finding(Kind.FAILURE, "stepState ends in an exception: " + StudentFailure.describe(e)));
        }
        return new SolverVerdict(identity, firstMistake(), identity.equals(MULTISTEP));
    }

    /** Whether it is a method of the kind that its name says. */
    private Optional<Finding> promised(Diagnosis diagnosis, boolean remembers) {
        return promise.filter(name -> name.remembers() && !remembers).map(name -> name.says() + ", as its name says,"
                + " uses derivatives or states of earlier steps; each step of this solver is the one that a new solver"
                + " makes, and nothing of earlier steps is used").or(() -> promise.filter(name -> name.adapts()
                && diagnosis.order() > 0).map(name -> "the name promises step-size control, and all steps are made with"
                + " one step size: is the error estimate always 0? Is it compared with the tolerance, and the sub-step"
                + " repeated when it is larger?")).map(text -> new Finding(Kind.METHOD, text));
    }

    private static SolverVerdict stopped(String identity, Kind kind, String text) {
        return new SolverVerdict(identity, List.of(new Finding(kind, text)), false);
    }

    private boolean isWrong() {
        return findings.stream().anyMatch(Finding::isWrong);
    }

    /** The first mistake, which explains the later ones, and all advice. */
    private List<Finding> firstMistake() {
        Optional<Finding> first = findings.stream().filter(Finding::isWrong).findFirst();
        return findings.stream().filter(finding -> !finding.isWrong() || finding == first.get()).distinct().toList();
    }

    private boolean repeats() {
        WindyOscillators one = new WindyOscillators(2);
        WindyOscillators two = one.copy();
        maker.get().stepState(one, SHORT);
        maker.get().stepState(two, SHORT);
        return Arrays.equals(one.state(), two.state()) && one.getTime() == two.getTime();
    }

    /** Whether a later step differs from the one that a new solver makes from the same place. */
    private boolean remembers() {
        DESolver solver = maker.get();
        WindyOscillators source = new WindyOscillators(2);
        for (int step = 0; step < 6; step++) {
            WindyOscillators twin = source.copy();
            maker.get().stepState(twin, SHORT);
            solver.stepState(source, SHORT);
            double[] expected = twin.state();
            double[] found = source.state();
            for (int k = 0; k < found.length; k++) {
                if (!(Math.abs(found[k] - expected[k]) <= 1e-11)) {
                    return true;
                }
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
        long once = source.evaluations();
        solver.stepState(source, SHORT);
        if (source.evaluations() == once) {
            found.add(new Finding(Kind.STATE, "the derivative is stale: getStateDerivative is called in the first step "
                    + "only, and"
                    + " each step needs the derivative at its own start"));
        }
        clock().ifPresent(found::add);
        if (multistep) {
            MultistepReading.of(maker).flatMap(MultistepReading::wrongWeights).ifPresent(found::add);
        }
        return new Diagnosis(multistep || BackwardDifferences.isRight(maker) ? MULTISTEP : UNREAD, found);
    }

    /**
     * Looks for mistakes of a method with memory that only the measured order shows, once its memory is known to be
     * reset in time.
     */
    private Optional<Finding> afterContract(boolean multistep) {
        Optional<Finding> begins = multistep ? MultistepReading.of(maker).flatMap(reading
                -> reading.poorBeginning(accuracy.order())) : Optional.empty();
        return begins.or(() -> accuracy.poorOrder(() -> firstSubStep(finding -> true)
                .or(() -> BackwardDifferences.wrong(maker).map(text -> new Finding(Kind.METHOD, text)))));
    }

    private Optional<Diagnosis> tableau(double size) {
        return new TableauReading(maker, promise, accuracy::order).diagnosis(size);
    }

    private Optional<Diagnosis> kicks() {
        for (int dimension : new int[] {3, 1}) {
            try {
                ExtractedKicks step = ExtractedKicks.of(maker.get(), H, dimension);
                List<EntryComparison> states = step.compare(maker.get(), H, dimension, 1);
                boolean adapts = step.compare(maker.get(), H, dimension, TableauReading.LARGE).isEmpty();
                boolean fits = !states.isEmpty() && !states.get(states.size() - 1).isWithout(KICKS_ROUNDING);
                if (fits && !adapts && !step.left()) {
                    findings.addAll(EntryComparison.leftOut(states, KICKS_ROUNDING));
                    return Optional.of(KicksDiagnosis.of(step, promise, accuracy::order, keepsArea()));
                }
            } catch (RuntimeException e) {
                continue;                               // not this dimension, or no such method
            }
        }
        return Optional.empty();
    }

    private boolean keepsArea() {
        Springs springs = new Springs();
        maker.get().stepState(springs, 1);
        return Math.abs(springs.steps().determinant() - 1) < 1e-10;
    }

    /** The diagnosis of a method whose coefficients cannot be read. */
    private Diagnosis measured() {
        UnreadMethod method = new UnreadMethod(maker);
        return new Diagnosis(UNREAD, clock()
                .or(method::entryByEntry)
                .or(() -> firstSubStep(finding -> finding.kind() != Kind.METHOD))
                .or(accuracy::layout)
                .or(() -> accuracy.poorOrder(() -> firstSubStep(finding -> true).or(method::unstable)))
                .or(method::uncontrolled).or(method::asymmetric).or(method::unstable).stream().toList());
    }

    /** A mistake in the first sub-step of an adaptive method, which it accepts where derivatives are tiny. */
    private Optional<Finding> firstSubStep(Predicate<Finding> which) {
        return tableau(TableauReading.TINY).flatMap(found -> found.findings().stream().filter(Finding::isWrong)
                .filter(which).findFirst());
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
                    return Optional.of(new Finding(Kind.TIME, wrongEnd(source, step, h, end)));
                }
            }
        }
        return Optional.empty();
    }

    private static String wrongEnd(WindyOscillators source, int step, double h, double end) {
        String when = step == 0 ? "" : "from step " + (step + 1) + " on ";
        return when + (end == 0 ? "the clock never moves: incTime(deltaT) is missing"
                : "the clock ends at " + Formula.time(end) + " after a step of deltaT = " + h
                + " s and has to end at t + deltaT" + (Math.abs(end - 1) < 1e-6
                && source.getTime() == (float) h ? ": it is moved in float arithmetic" : end > 1
                && source.error() < SMALL_ERROR ? ", and the state is where the clock is: the last sub-step has"
                + " to be cut to what is left of deltaT" : ""));
    }

    private long evaluations(double deltaT) {
        NonlinearOscillators source = new NonlinearOscillators(1);
        try {
            maker.get().stepState(source, deltaT);
        } catch (RuntimeException e) {
            return -1;                                  // too long for it, which a multistep method would not notice
        }
        return source.evaluations();
    }
}
