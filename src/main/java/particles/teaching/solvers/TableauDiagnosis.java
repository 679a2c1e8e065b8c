package particles.teaching.solvers;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import particles.teaching.Finding.Kind;
import particles.teaching.Finding;
import particles.teaching.Formula;

/** Names a method whose coefficients were read off with three time steps, and what is wrong with it. */
final class TableauDiagnosis {
    /** More evaluations than in a method that somebody got wrong. */
    private static final int MANY = 4;

    private final ExtractedTableau step;
    private final ExtractedTableau twice;
    private final ExtractedTableau back;
    private final Optional<KnownMethod> promised;
    private final List<Finding> findings = new ArrayList<>();
    private final double h;
    private double[][] a;
    private double[] b;
    private double[] c;

    private TableauDiagnosis(ExtractedTableau step, ExtractedTableau twice, ExtractedTableau back,
            Optional<KnownMethod> promised) {
        this.step = step;
        this.twice = twice;
        this.back = back;
        this.promised = promised;
        this.h = step.h();
        a = Arrays.stream(step.a()).map(row -> Arrays.stream(row).map(x -> x / h).toArray()).toArray(double[][]::new);
        b = Arrays.stream(step.b()).map(x -> x / h).toArray();
        c = Arrays.stream(step.c()).map(x -> x / h).toArray();
    }

    /**
     * @param step     a step of h
     * @param twice    a step of 2 h, with as many evaluations
     * @param back     a step of -h, with as many evaluations
     * @param promised the method that it should be, if that is known
     * @return what it is
     */
    static Diagnosis of(ExtractedTableau step, ExtractedTableau twice, ExtractedTableau back, Optional<KnownMethod> promised) {
        return new TableauDiagnosis(step, twice, back, promised).diagnose();
    }

    private void wrong(Kind kind, String text) {
        findings.add(new Finding(kind, text));
    }

    private Diagnosis diagnose() {
        if (step.stages() == 0) {
            wrong(Kind.METHOD, "getStateDerivative is never called: without the derivative the solver cannot know where to go");
        }
        boolean clock = checkClock();
        boolean end = checkState() && checkDeltaT();
        if (step.stages() == 0) {
            return new Diagnosis("It makes no step.", findings);
        }
        String identity = compare(end, clock);
        return new Diagnosis(identity, findings);
    }

    /** @return whether the clock tells more than what was said */
    private boolean checkClock() {
        double end = step.end() / h;
        if (Formula.same(end, 1) && Formula.same(twice.end() / twice.h(), 1) && Formula.same(back.end() / back.h(), 1)) {
            return true;
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
        if (ahead != 0 && Formula.same(twice.end() - twice.h(), ahead) && Formula.same(back.end() - back.h(), ahead)) {
            wrong(Kind.TIME, "the clock moves by " + Formula.number(step.end()) + " s in a step of " + Formula.number(h)
                    + " s that begins at "
                    + Formula.number(ahead) + " s: incTime takes how far the clock moves, deltaT, and not the new time");
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
            wrong(Kind.TIME, "the clock ends at " + Formula.time(end) + " and has to end at t + deltaT; it was moved by "
                    + String.join(", then ", moves)
                    + ": all moves together have to make deltaT");
        }
        return true;
    }

    /** @return whether the new state tells more than what was said */
    private boolean checkState() {
        if (!step.wrongLengths().isEmpty()) {
            wrong(Kind.STATE, "an array of " + step.wrongLengths().get(0) + " numbers was handed to a source whose state has 24:"
                    + " arrays have to be source.getStateSize() long");
        }
        if (step.stages() == 0 && !step.everSet()) {
            return false;
        }
        if (!step.everSet()) {
            wrong(Kind.STATE, "the new state never reaches the source: setState(state) is missing");
            return false;
        }
        if (!step.setAfterLast()) {
            wrong(Kind.STATE, step.stages() > 1 ? "the state is left at a trial state, "
                    + Formula.state(step.kept(), b, stepNames())
                    + ", that of the last evaluation: setState with the new state is missing at the end"
                    : "the state is set before the derivative is known, and never to the new state: setState(state) is missing at the end");
            return false;
        }
        for (int i = 0; i < step.stages(); i++) {
            if (!Formula.same(step.keptAt()[i], 1)) {
                wrong(Kind.STATE, names().get(i) + " is evaluated at a state with " + Formula.number(step.keptAt()[i])
                        + " times s in it; every trial state is s plus increments");
            }
        }
        if (!Formula.same(step.kept(), 1)) {
            wrong(Kind.STATE, step.kept() == 0 ? "the old state is lost: the new state is " + Formula.state(0, b, stepNames())
                    + " and has to be s plus that (+=, not =)"
                    : "the new state has " + Formula.number(step.kept()) + " times s in it instead of s");
        }
        return true;
    }

    /** @return whether the step is made with deltaT, so that its weights can be compared */
    private boolean checkDeltaT() {
        for (int i = 1; i < step.stages(); i++) {
            String fault = fault(MethodDifferences.sum(step.a()[i]), MethodDifferences.sum(twice.a()[i]),
                    MethodDifferences.sum(back.a()[i]));
            if (!fault.isEmpty()) {
                wrong(Kind.METHOD, names().get(i) + " is evaluated at a state that is off: " + fault);
            }
        }
        String fault = fault(MethodDifferences.sum(step.b()), MethodDifferences.sum(twice.b()), MethodDifferences.sum(back.b()));
        if (!fault.isEmpty()) {
            wrong(Kind.METHOD, "the new state does not follow deltaT: " + fault);
        }
        return fault.isEmpty();
    }

    /** What the sum of a row's coefficients does when deltaT is doubled and when its sign changes. */
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
        return Formula.same(ratio, 4) ? "deltaT is multiplied in twice" : "with twice the deltaT it moves "
                + Formula.number(ratio) + " times as far";
    }

    private List<String> names() {
        return promised.filter(method -> method.stages() >= step.stages()).map(KnownMethod::slopes).orElseGet(this::numbered);
    }

    private List<String> stepNames() {
        return promised.filter(method -> method.stages() >= step.stages()).map(KnownMethod::steps).orElseGet(this::numbered);
    }

    private List<String> numbered() {
        List<String> names = new ArrayList<>();
        for (int i = 1; i <= step.stages(); i++) {
            names.add("k" + i);
        }
        return names;
    }

    private String compare(boolean end, boolean clock) {
        dropUnused(end);
        double[] weights = end ? b : new double[0];
        double[] clocks = clock ? c : new double[0];
        Optional<KnownMethod> exact = KnownMethod.all().stream()
                .filter(method -> MethodDifferences.of(method, a, weights, clocks, step).isEmpty()).findFirst();
        if (promised.isPresent()) {
            KnownMethod method = promised.get();
            List<Finding> differences = MethodDifferences.of(method, a, weights, clocks, step);
            if (differences.isEmpty()) {
                return "This is " + method.name() + (findings.isEmpty() ? "." : " but for what is wrong below.");
            }
            if (end && exact.isPresent()) {
                wrong(Kind.METHOD, "this is " + exact.get().name() + " and not " + method.name() + ", as its name says");
            }
            findings.addAll(differences);
            return exact.filter(found -> end).map(found -> "This is " + found.name() + ".").orElse("This is " + method.name()
                    + " but for what is wrong below.");
        }
        if (exact.isPresent()) {
            return "This is " + exact.get().name() + (findings.isEmpty() ? "." : " but for what is wrong below.");
        }
        int order = end && clock ? OrderConditions.order(a, b, c) : 0;
        if (order >= 2 || order == 1 && b.length > MANY && MethodDifferences.isConsistent(a, c)) {
            return "This is a Runge-Kutta method of order " + order + (order == 4 ? " or more" : "") + " with " + b.length
                    + " evaluations a step; its coefficients are none that we know by name.";
        }
        return nearest(weights, clocks);
    }

    private String nearest(double[] weights, double[] clocks) {
        if (isTwoEulerSteps()) {
            findings.clear();
            wrong(Kind.METHOD, "two Euler steps of deltaT are made, and the clock moves by 2 deltaT; one is wanted");
            return "This is the Euler method, twice.";
        }
        KnownMethod nearest = KnownMethod.all().stream()
                .min(Comparator.comparingInt(method -> MethodDifferences.of(method, a, weights, clocks,
                        step).size())).orElseThrow();
        List<Finding> differences = MethodDifferences.of(nearest, a, weights, clocks, step);
        if (b.length > MANY && differences.size() > MANY) {
            wrong(Kind.METHOD, "with " + b.length + " evaluations this is no method that we know, and its weights "
                    + (weights.length == 0
                    || Formula.same(MethodDifferences.sum(weights), 1) ? ""
                    : "do not add up to 1 but to " + Formula.number(MethodDifferences.sum(weights))
                    + ", or its ") + "places and clocks do not belong together: each stage at the time t + c deltaT has to be where c deltaT leads");
            return "This is a method of one's own, but for what is wrong below.";
        }
        findings.addAll(differences);
        return "This is nearest to " + nearest.name() + ", but for what is wrong below.";
    }

    private boolean isTwoEulerSteps() {
        return b.length == 2 && Formula.same(step.end(), 2 * h) && Formula.same(b[0], 1) && Formula.same(b[1], 1)
                && Formula.same(a[1][0], 1)
                && Formula.same(c[1], 1);
    }

    /** An evaluation at the end that enters nothing is a waste, but no mistake. */
    private void dropUnused(boolean end) {
        int used = b.length;
        while (end && used > 1 && b[used - 1] == 0 && promised.map(method -> method.stages() < b.length).orElse(true)
                && Arrays.stream(b).anyMatch(w -> w != 0)) {
            used--;
        }
        if (used < b.length) {
            findings.add(new Finding(Kind.ADVICE, "the last " + (b.length - used == 1 ? "evaluation enters"
                    : b.length - used + " evaluations enter")
                    + " nothing, and could be left out"));
            int stages = used;
            a = Arrays.stream(Arrays.copyOf(a, stages)).map(row -> Arrays.copyOf(row, stages)).toArray(double[][]::new);
            b = Arrays.copyOf(b, stages);
            c = Arrays.copyOf(c, stages);
        }
    }
}
