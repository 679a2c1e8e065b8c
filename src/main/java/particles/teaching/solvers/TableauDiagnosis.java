package particles.teaching.solvers;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleSupplier;
import particles.teaching.Finding.Kind;
import particles.teaching.Finding;
import particles.teaching.Formula;

/** Identifies a method from the coefficients of steps with several deltaT, and its mistakes. */
final class TableauDiagnosis {
    private final ExtractedTableau step;
    private final ExtractedTableau twice;
    private final Optional<ExtractedTableau> back;
    private final Optional<NamePromise> promise;
    private final DoubleSupplier measured;
    private final List<Finding> findings = new ArrayList<>();
    private final double h;
    private final double[][] a;
    private final double[] b;
    private final double[] c;

    private TableauDiagnosis(ExtractedTableau step, ExtractedTableau twice, Optional<ExtractedTableau> back,
            Optional<NamePromise> promise, DoubleSupplier measured) {
        this.step = step;
        this.twice = twice;
        this.back = back;
        this.promise = promise;
        this.measured = measured;
        this.h = step.h();
        a = Arrays.stream(step.a()).map(row -> Arrays.stream(row).map(x -> x / h).toArray()).toArray(double[][]::new);
        b = Arrays.stream(step.b()).map(x -> x / h).toArray();
        c = Arrays.stream(step.c()).map(x -> x / h).toArray();
    }

    /**
     * @param step     a step of h
     * @param twice    a step of 2 h, with as many evaluations
     * @param back     a step of -h, with as many evaluations, if it makes one
     * @param promise  the method that the class's name promises
     * @param measured gives the measured order
     * @return the diagnosis
     */
    static Diagnosis of(ExtractedTableau step, ExtractedTableau twice, Optional<ExtractedTableau> back,
            Optional<NamePromise> promise, DoubleSupplier measured) {
        return new TableauDiagnosis(step, twice, back, promise, measured).diagnose();
    }

    private void wrong(Kind kind, String text) {
        findings.add(new Finding(kind, text));
    }

    private Diagnosis diagnose() {
        if (!step.everSet() && step.clockMoves().isEmpty()) {
            wrong(Kind.STATE, "the step does nothing yet: setState with the new state and incTime(deltaT) are missing");
        }
        if (step.stages() == 0) {
            wrong(Kind.METHOD, "getStateDerivative is never called: without the derivative the solver cannot know "
                    + "where to go");
        }
        boolean clock = checkClock();
        boolean end = checkState() && checkDeltaT();
        if (step.stages() == 0) {
            return new Diagnosis("It makes no step.", findings);
        }
        TableauComparison comparison = new TableauComparison(step, a, b, c, promise, measured, findings);
        String identity = comparison.identity(end, clock);
        return new Diagnosis(identity, findings, comparison.order());
    }

    /** @return whether the clock can be compared further */
    private boolean checkClock() {
        double end = step.end() / h;
        if (Formula.sameTime(end, 1) && Formula.sameTime(twice.end() / twice.h(), 1)
                && back.stream().allMatch(step -> Formula.sameTime(step.end() / step.h(), 1))) {
            return true;
        }
        if (Formula.sameTime(end, 1) && Formula.sameTime(twice.end() / twice.h(), 1)) {
            double clock = back.orElseThrow().end();
            wrong(Kind.TIME, "with deltaT = " + Formula.number(-h) + " s the clock moves by " + Formula.number(clock)
                    + " s" + (clock == h ? ": the sign of deltaT is lost, and a step back goes forward" : ""));
            return false;
        }
        if (step.clockMoves().isEmpty()) {
            wrong(Kind.TIME, "the clock never moves: incTime(deltaT) is missing");
            return false;
        }
        if (Formula.same(twice.end(), step.end()) && step.end() != 0) {
            wrong(Kind.TIME, "the clock moves by " + Formula.number(step.end())
                    + " s in every step, whatever deltaT is: it is hard-coded;"
                    + " incTime(deltaT) is meant");
            return false;
        }
        boolean calls = step.clockMoves().stream().allMatch(move -> move == h);
        double ahead = step.end() - h;
        if (Math.abs(ahead) > 1e-3 && Formula.same(twice.end() - twice.h(), ahead)) {
            wrong(Kind.TIME, "the clock moves by " + Formula.number(step.end()) + " s in a step of " + Formula.number(h)
                    + " s that begins at "
                    + Formula.number(ahead) + " s: incTime takes how far the clock moves, deltaT, and not the new "
                    + "time");
            return false;
        }
        if (calls && step.stages() > 2) {
            wrong(Kind.TIME, "the clock moves by " + Formula.number(end) + " deltaT: incTime(deltaT) is called "
                    + step.clockMoves().size()
                    + " times, and all moves together have to make one deltaT");
            return false;
        }
        if (calls) {
            wrong(Kind.TIME, "the clock moves by " + Formula.number(end) + " deltaT: incTime(deltaT) is called "
                    + step.clockMoves().size()
                    + " times, once is right");
        } else {
            List<String> moves = step.clockMoves().stream().map(move -> Formula.state(0, new double[] {move / h},
                    List.of("deltaT"))).toList();
            wrong(Kind.TIME, "the clock ends at " + Formula.time(end) + " and has to end at t + deltaT; it was moved "
                    + "by "
                    + String.join(", then ", moves)
                    + ": all moves together have to make deltaT");
        }
        return true;
    }

    /** @return whether the new state can be compared further */
    private boolean checkState() {
        if (!step.wrongLengths().isEmpty()) {
            wrong(Kind.STATE, "an array of " + step.wrongLengths().get(0)
                    + " numbers was handed to a source whose state has 24:"
                    + " arrays have to be source.getStateSize() long");
        }
        if (step.stages() == 0 && !step.everSet()) {
            return false;
        }
        if (!step.everSet()) {
            wrong(Kind.STATE, "the new state never reaches the source: setState(state) is missing");
            return false;
        }
        if (!step.setAfterLast() && !evaluatesTheNewState()) {
            wrong(Kind.STATE, step.stages() > 1 ? "the state is left at a trial state, "
                    + Formula.state(step.kept(), b, stepNames())
                    + ", that of the last evaluation: setState with the new state is missing at the end"
                    : "the state is set before the derivative is known, and never to the new state: setState(state) is "
                    + "missing at the end");
            return false;
        }
        for (int i = 0; i < step.stages(); i++) {
            if (!Formula.same(step.keptAt()[i], 1)) {
                wrong(Kind.STATE, names().get(i) + " is evaluated at a state with " + Formula.number(step.keptAt()[i])
                        + " times s in it; every trial state is s plus increments");
            }
        }
        if (!Formula.same(step.kept(), 1)) {
            wrong(Kind.STATE, step.kept() == 0 ? "the old state is lost: the new state is " + Formula.state(0, b,
                    stepNames())
                    + " and has to be s plus that (+=, not =)"
                    : "the new state has " + Formula.number(step.kept()) + " times s in it instead of s");
        }
        return true;
    }

    /** @return whether the step is made with deltaT, so that its weights can be compared */
    private boolean checkDeltaT() {
        for (int i = 1; i < step.stages(); i++) {
            int stage = i;
            String fault = fault(MethodDifferences.sum(step.a()[i]), MethodDifferences.sum(twice.a()[i]),
                    back.map(step -> MethodDifferences.sum(step.a()[stage])).orElse(Double.NaN));
            if (!fault.isEmpty()) {
                wrong(Kind.METHOD, names().get(i) + " is evaluated at a state that is off: " + fault);
            }
        }
        String fault = fault(MethodDifferences.sum(step.b()), MethodDifferences.sum(twice.b()),
                back.map(step -> MethodDifferences.sum(step.b())).orElse(Double.NaN));
        if (!fault.isEmpty()) {
            wrong(Kind.METHOD, "the new state does not follow deltaT: " + fault);
        }
        return fault.isEmpty();
    }

    /**
     * The mistake behind the change of a row's sum of coefficients when deltaT is doubled and when its sign changes.
     */
    private String fault(double once, double doubled, double negative) {
        if (once == 0 || Formula.same(doubled / once, 2)) {
            return once != 0 && negative == once ? "the sign of deltaT is lost, and a step back goes forward" : "";
        }
        double ratio = doubled / once;
        if (Formula.same(ratio, 1)) {
            return Formula.same(once, 1) || Formula.same(once, 0.5)
                    ? "deltaT is ignored; the derivative has to be multiplied by deltaT"
                    : Formula.same(once, ExtractedTableau.START)
                    ? "its length is the time, source.getTime(), and deltaT is ignored"
                    : "a time step of " + Formula.number(once) + " s is hard-coded, and deltaT is ignored";
        }
        if (Formula.same(ratio, 0.5)) {
            return "the derivative is divided by deltaT; it has to be multiplied by deltaT";
        }
        double constant = 2 * once - doubled;
        boolean part = Formula.same(negative, 2 * constant - once);
        return Formula.same(ratio, 4) ? "deltaT is multiplied in twice" : "with twice the deltaT it moves "
                + Formula.number(ratio) + " times as far" + (part ? ", as a part of it is not multiplied by deltaT: are"
                + " brackets missing?" : "");
    }

    private List<String> names() {
        return KnownMethod.meantBy(promise, step.stages()).map(KnownMethod::slopes)
                .orElseGet(() -> KnownMethod.numbered(step.stages()));
    }

    private List<String> stepNames() {
        return KnownMethod.meantBy(promise, step.stages()).map(KnownMethod::steps)
                .orElseGet(() -> KnownMethod.numbered(step.stages()));
    }

    /** A step may end with the derivative at its new state, kept for the next one (FSAL), or for nothing. */
    private boolean evaluatesTheNewState() {
        int last = step.stages() - 1;
        return last > 0 && !KnownMethod.isRowsOfAny(a) && Formula.same(MethodDifferences.sum(b), 1)
                && Formula.same(c[last], 1);
    }
}
