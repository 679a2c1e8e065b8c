package particles.teaching.solvers;

import deSolvers.DESolver;
import deSolvers.DESolverException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import particles.teaching.Finding.Kind;
import particles.teaching.Finding;
import particles.teaching.Formula;
import particles.teaching.StudentFailure;
import particles.teaching.sources.Probe;
import particles.teaching.sources.WindyOscillators;

/**
 * Finds out what method a solver is, and what is wrong with it. First a step is read off coefficient by coefficient; a
 * method without a tableau is judged by what it does. All takes well under a second for an explicit method.
 */
public final class SolverCheck {
    private static final double H = 1.0 / 4;
    /** A few roundings of double arithmetic; measured 3e-16 for RK4. */
    private static final double DOUBLE_ROUNDING = 1e-13;
    /** Below this it may be float arithmetic, with roundings of 6e-8, or numbers that are rounded to a few decimals. */
    private static final double FLOAT_ROUNDING = 1e-3;
    /** Derivatives that nobody expects, to find what is cut off. */
    private static final double LARGE = 1e3;
    /** Below this order the error does not go to 0; Euler measures 0.97 to 1.03. */
    private static final double LOWEST_ORDER = 0.7;
    /** Adaptive methods have an error that does not follow deltaT, and a small one. */
    private static final double SMALL_ERROR = 1e-4;

    private final Supplier<DESolver> maker;
    private final String className;
    private final List<Finding> findings = new ArrayList<>();

    private SolverCheck(Supplier<DESolver> maker, String className) {
        this.maker = maker;
        this.className = className;
    }

    /**
     * Checks a solver.
     *
     * @param maker     makes a new one
     * @param className the simple name of its class, which may promise a method, as HeunSolver does
     * @return what it is and what was found
     */
    public static SolverVerdict check(Supplier<DESolver> maker, String className) {
        return new SolverCheck(maker, className).verdict();
    }

    private SolverVerdict verdict() {
        try {
            WindyOscillators source = new WindyOscillators(2);
            maker.get().stepState(source, 1.0 / 16);
            if (!Double.isFinite(MethodDifferences.sum(source.state()))) {
                return new SolverVerdict("It makes no step.",
                        List.of(new Finding(Kind.STATE, "the new state is NaN or infinite although state"
                        + " and derivative are finite: look for 0/0, the root of a negative number, or a division by something that is 0")),
                        false);
            }
        } catch (RuntimeException e) {
            return new SolverVerdict("It makes no step.", List.of(new Finding(Kind.FAILURE, "stepState ends in an exception: "
                    + StudentFailure.describe(e))), false);
        }
        if (!repeats()) {
            return new SolverVerdict("It makes another step each time.",
                    List.of(new Finding(Kind.METHOD, "two new solvers make different steps from"
                    + " the same place: something is random, or static and shared by all solvers (a static field outlives a step and its solver)")),
                    false);
        }
        boolean remembers = remembers();
        boolean multistep = remembers && evaluations(1.0 / 16) == evaluations(8);
        Diagnosis diagnosis = remembers ? measured(multistep)
                : tableau().or(this::kicks).orElseGet(() -> measured(false));
        diagnosis.findings().stream().filter(finding -> !findings.contains(finding)).forEach(findings::add);
        if (!remembers || findings.isEmpty()) {
            try {
                addContract(multistep);
            } catch (RuntimeException e) {
                findings.add(new Finding(Kind.FAILURE, "stepState ends in an exception: " + StudentFailure.describe(e)));
            }
        }
        return new SolverVerdict(diagnosis.identity(), findings, multistep);
    }

    /** Where the formula is wrong already, a contract that is broken for the same reason is not said again. */
    private void addContract(boolean multistep) {
        boolean wrong = findings.stream().anyMatch(Finding::isWrong);
        for (Finding finding : SolverContract.check(maker, multistep)) {
            if (!wrong || finding.kind() == Kind.ADVICE) {
                findings.add(finding);
            }
        }
    }

    private boolean repeats() {
        WindyOscillators one = new WindyOscillators(2);
        WindyOscillators two = one.copy();
        maker.get().stepState(one, 1.0 / 16);
        maker.get().stepState(two, 1.0 / 16);
        return Arrays.equals(one.state(), two.state()) && one.getTime() == two.getTime();
    }

    /** Whether a later step differs from the one that a new solver makes from the same place. */
    private boolean remembers() {
        DESolver solver = maker.get();
        WindyOscillators source = new WindyOscillators(2);
        for (int step = 0; step < 6; step++) {
            WindyOscillators twin = source.copy();
            maker.get().stepState(twin, 1.0 / 16);
            long before = source.evaluations();
            solver.stepState(source, 1.0 / 16);
            double[] expected = twin.state();
            double[] found = source.state();
            double distance = 0;
            for (int k = 0; k < found.length; k++) {
                distance = Math.max(distance, Math.abs(found[k] - expected[k]));
            }
            if (distance > 1e-11) {
                if (OrderMeasurement.of(maker).order() < LOWEST_ORDER) {
                    findings.add(new Finding(Kind.STATE, source.evaluations() == before
                            ? "the derivative is stale: getStateDerivative is called in the first step only, and each step needs the derivative"
                                    + " at its own start"
                            : "the derivative is stale: step " + (step + 1)
                            + " is not the one that a new solver makes from the same place, and the"
                                    + " error does not go to 0 with deltaT. Something from the step before is used again; getStateDerivative has"
                                    + " to be called anew, after the state and the clock were set"));
                }
                return true;
            }
        }
        return false;
    }

    private Optional<Diagnosis> tableau() {
        try {
            ExtractedTableau step = ExtractedTableau.of(maker.get(), H);
            ExtractedTableau twice = ExtractedTableau.of(maker.get(), 2 * H);
            ExtractedTableau back = ExtractedTableau.of(maker.get(), -H);
            if (step.stages() != twice.stages() || step.stages() != back.stages() || !fits(step.misfit(maker.get(), 1))) {
                return Optional.empty();
            }
            if (Arrays.stream(step.misfit(maker.get(), LARGE)).anyMatch(difference -> difference > FLOAT_ROUNDING)) {
                findings.add(new Finding(Kind.METHOD, "with derivatives up to " + Formula.number(LARGE)
                        + " the step is not the one that it makes with"
                        + " derivatives up to 1: something is cut off, or depends on the size"));
            }
            Diagnosis diagnosis = TableauDiagnosis.of(step, twice, back,
                    KicksDiagnosis.isPromisedBy(className) ? Optional.empty() : KnownMethod.promisedBy(className));
            if (diagnosis.identity().startsWith("This is the Euler method")) {
                KicksDiagnosis.eulerInstead(className).ifPresent(findings::add);
            }
            return Optional.of(diagnosis);
        } catch (Probe.TooManyEvaluations | DESolverException e) {
            return Optional.empty();
        } catch (IllegalArgumentException | ClassCastException e) {
            return Optional.empty();                    // it wants a source of second order
        }
    }

    /** Whether a step with random numbers is what the coefficients say, perhaps but for what is then a finding. */
    private boolean fits(double[] misfit) {
        double largest = 0;
        List<Integer> left = new ArrayList<>();
        for (int k = 0; k < misfit.length; k++) {
            if (Double.isNaN(misfit[k])) {
                left.add(k);
            } else {
                largest = Math.max(largest, misfit[k]);
            }
        }
        if (largest > FLOAT_ROUNDING || left.size() == misfit.length) {
            return false;
        }
        if (!left.isEmpty()) {
            boolean row = left.get(left.size() - 1) - left.get(0) == left.size() - 1 && left.size() > 2;
            findings.add(new Finding(Kind.STATE, "entr" + (left.size() == 1 ? "y " : "ies ")
                    + (row ? left.get(0) + " to " + left.get(left.size() - 1) : left.toString().replaceAll("[\\[\\]]", ""))
                    + " of a state of " + misfit.length + " numbers stay" + (left.size() == 1 ? "s"
                    : "") + " as it was: the loop over i has to go"
                    + " from 0 to source.getStateSize() - 1"));
        }
        if (largest > DOUBLE_ROUNDING) {
            findings.add(new Finding(Kind.STATE, "digits get lost: the new state is off by " + Formula.number(largest)
                    + " of its size, as " + (largest < 1e-6 ? "in float arithmetic; all numbers have to be double"
                            : "if a number were rounded on the way; only what is printed may be")));
        }
        return true;
    }

    private Optional<Diagnosis> kicks() {
        for (int dimension : new int[] {3, 1}) {
            try {
                ExtractedKicks step = ExtractedKicks.of(maker.get(), H, dimension);
                if (step.misfit(maker.get(), H, dimension) < 1e-12 && !step.left()) {
                    return Optional.of(KicksDiagnosis.of(step, className));
                }
            } catch (Probe.TooManyEvaluations | DESolverException | IndexOutOfBoundsException e) {
                continue;                               // not this dimension, or no such method
            }
        }
        return Optional.empty();
    }

    /** Methods that cannot be read off. */
    private Diagnosis measured(boolean multistep) {
        String identity = multistep ? "This is a method that uses earlier steps (a multistep method)."
                : "This is a method without fixed coefficients, adaptive or implicit.";
        OrderMeasurement measured = OrderMeasurement.of(maker);
        List<Finding> found = new ArrayList<>();
        WindyOscillators source = new WindyOscillators(1);
        maker.get().stepState(source, H);
        if (Math.abs(source.getTime() - H) > 1e-15) {
            found.add(new Finding(Kind.TIME, source.getTime() == 0 ? "the clock never moves: incTime(deltaT) is missing"
                    : "the clock ends at t + " + source.getTime() + " after a step of " + H));
        }
        if (found.isEmpty() && measured.order() >= LOWEST_ORDER && !(OrderMeasurement.of(maker, 2).order() >= LOWEST_ORDER)
                && !(OrderMeasurement.of(maker, 2).smallestError() < SMALL_ERROR)) {
            found.add(new Finding(Kind.STATE, "with one particle the error goes to 0 with deltaT, with two it does not: the state is three positions and"
                    + " three velocities for each particle in turn, (x1, v1, x2, v2, ...), and not all positions and then all velocities"));
        }
        boolean explained = findings.stream().anyMatch(Finding::isWrong) || !found.isEmpty();
        if (!explained && !(measured.order() >= LOWEST_ORDER) && !(measured.smallestError() < SMALL_ERROR)) {
            found.add(new Finding(Kind.METHOD, "the error does not go to 0 with deltaT: over the same time it is "
                    + measured.points().stream().map(point -> Formula.number(point[1])).toList()
                    + " with deltaT = " + measured.points().stream().map(point -> Formula.number(point[0])).toList()));
        }
        return new Diagnosis(identity, found);
    }

    private long evaluations(double deltaT) {
        WindyOscillators source = new WindyOscillators(1);
        maker.get().stepState(source, deltaT);
        return source.evaluations();
    }
}
