package particles.teaching.solvers;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import particles.teaching.Finding;
import particles.teaching.Formula;

/** The differences between measured coefficients and those of a known method, each in a sentence. */
final class MethodDifferences {
    private static final double FLOAT_ROUNDING = 1e-6;

    private final KnownMethod method;
    private final double[][] a;
    private final double[] b;
    private final double[] c;
    private final ExtractedTableau step;
    private final List<Finding> found = new ArrayList<>();
    private int count;

    private MethodDifferences(KnownMethod method, double[][] a, double[] b, double[] c, ExtractedTableau step) {
        this.method = method;
        this.a = a;
        this.b = b;
        this.c = c;
        this.step = step;
    }

    /**
     * @param method  the method with which it is compared
     * @param a       the rows, in units of deltaT
     * @param b       the weights, in units of deltaT; empty if they tell nothing
     * @param c       the clocks, in units of deltaT; empty if they tell nothing
     * @param step    the step from which all was read
     * @return the differences
     */
    static MethodDifferences of(KnownMethod method, double[][] a, double[] b, double[] c, ExtractedTableau step) {
        MethodDifferences differences = new MethodDifferences(method, a, b, c, step);
        differences.compareStages();
        differences.compareClocks();
        differences.compareWeights();
        return differences;
    }

    boolean isEmpty() {
        return found.isEmpty();
    }

    /** @return the method with which it was compared */
    KnownMethod method() {
        return method;
    }

    /** @return the number of stages that differ in number, state or time; wrong weights count once */
    int count() {
        return count;
    }

    /** @return the number of weights that differ, to choose among methods that differ in the weights only */
    int wrongWeights() {
        double[] expected = Arrays.copyOf(method.weights(), Math.max(b.length, method.stages()));
        double[] weights = Arrays.copyOf(b, expected.length);
        return (int) IntStream.range(0, expected.length).filter(j -> !Formula.same(weights[j], expected[j])).count();
    }

    /** @return one mistake that explains all differences, or else the first of them */
    Finding first() {
        return aliased().orElse(found.get(0));
    }

    /** Two mistakes with arrays that make every later line wrong. */
    private Optional<Finding> aliased() {
        int n = method.stages();
        if (a.length != n || n < 3 || b.length == 0) {
            return Optional.empty();
        }
        double[] sum = new double[n];
        boolean cumulative = true;
        boolean shared = true;
        for (int i = 1; i < n; i++) {
            sum = plus(sum, method.row(i));
            double[] last = new double[n];
            last[i - 1] = sum(method.row(i));
            cumulative &= same(a[i], sum);
            shared &= same(a[i], last);
        }
        double[] last = new double[n];
        last[n - 1] = 1;
        if (cumulative) {
            return Optional.of(new Finding(Finding.Kind.STATE, "every trial state is added to the one before, as "
                    + slope(2) + " at "
                    + Formula.state(1, a[2], method.steps()) + " shows: go back to the start s before adding. double[] "
                    + "trial = s"
                    + " makes no copy; s.clone() does"));
        }
        return shared && same(b, last) ? Optional.of(new Finding(Finding.Kind.STATE, "all of " + slope(0) + " to "
                + slope(n - 1)
                + " are one array, which each evaluation writes over: the new state is " + Formula.state(step.kept(), b,
                method.steps()) + "; give each an array of its own")) : Optional.empty();
    }

    private void wrong(Finding.Kind kind, String text) {
        found.add(new Finding(kind, text));
        count++;
    }

    private String slope(int i) {
        return i < method.stages() ? method.slopes().get(i) : "the derivative number " + (i + 1);
    }

    private void compareStages() {
        for (int i = a.length; i < method.stages(); i++) {
            wrong(Finding.Kind.METHOD, slope(i) + " is missing: getStateDerivative is called " + times(a.length) + ", "
                    + method.authority() + " needs " + times(method.stages()));
        }
        for (int i = method.stages(); i < a.length; i++) {
            wrong(Finding.Kind.METHOD, "there is an evaluation too many: getStateDerivative is called "
                    + times(a.length) + ", "
                    + method.authority() + " needs " + times(method.stages()));
        }
        for (int i = 0; i < Math.min(a.length, method.stages()); i++) {
            double[] expected = Arrays.copyOf(method.row(i), a.length);
            if (!same(a[i], expected)) {
                wrong(Finding.Kind.METHOD, slope(i) + " is evaluated at " + Formula.state(1, a[i], method.steps())
                        + "; "
                        + method.authority()
                        + " says " + Formula.state(1, expected, method.steps()) + stageHint(i, expected));
            }
        }
    }

    private static String times(int n) {
        return n == 1 ? "once" : n == 2 ? "twice" : n + " times";
    }

    private String stageHint(int i, double[] expected) {
        if (!step.stateSet()[i] && i > 0) {
            return ": setState is missing before this getStateDerivative, so that it is "
                    + (sum(a[i]) == 0 ? "the derivative at the old state once more, " + slope(0) + " again"
                    : slope(i - 1) + " again");
        }
        if (i > 0 && sum(a[i]) == 0) {
            return ": nothing is added to s; " + wholeNumbers(expected);
        }
        if (i > 0 && same(a[i], plus(expected, a[i - 1]))) {
            return ": go back to the start s before adding";
        }
        return factorHint(a[i], expected);
    }

    private static String wholeNumbers(double[] expected) {
        String fraction = Arrays.stream(expected).map(Math::abs).mapToObj(Formula::number)
                .filter(number -> number.contains("/")).findFirst().orElse("1/2");
        return fraction + " is 0 in Java, as both are whole numbers, and " + fraction.replace("/", ".0/") + " is meant";
    }

    /** A row that is a multiple of the right one, or that one in float. */
    private static String factorHint(double[] found, double[] expected) {
        if (IntStream.range(0, found.length).allMatch(j -> Math.abs(found[j] - expected[j]) < FLOAT_ROUNDING)) {
            return ": only the first seven digits are right, as in float arithmetic; all numbers have to be double";
        }
        for (double factor : new double[] {-1, 2, 0.5, -0.5, -2}) {
            double[] scaled = Arrays.stream(expected).map(x -> factor * x).toArray();
            if (same(found, scaled)) {
                return factor < 0 ? ": the sign is wrong" : factor == 2 ? ": the half is missing"
                        : ": it is halved once too often";
            }
        }
        return "";
    }

    private void compareClocks() {
        List<Integer> wrong = new ArrayList<>();
        for (int i = 0; i < Math.min(c.length, method.stages()); i++) {
            if (!Formula.sameTime(c[i], method.tableau().node(i))) {
                wrong.add(i);
            }
        }
        if (wrong.isEmpty()) {
            return;
        }
        String found = wrong.stream().map(i -> Formula.time(c[i])).distinct().count() == 1
                ? Formula.time(c[wrong.get(0)])
                : join(wrong.stream().map(i -> Formula.time(c[i])).toList());
        boolean neverMoved = wrong.size() > 1 && wrong.stream().allMatch(i -> c[i] == 0);
        count += wrong.size() > 1 ? 1 : 0;
        wrong(Finding.Kind.TIME, join(wrong.stream().map(this::slope).toList()) + (wrong.size() == 1 ? " is" : " are")
                + " evaluated at " + found + "; " + method.authority() + " says "
                + join(wrong.stream().map(i -> Formula.time(method.tableau().node(i))).toList()) + (neverMoved
                ? ": the clock has to be moved with incTime before each evaluation, and not only at the end" : ""));
    }

    private static String join(List<String> words) {
        return words.size() < 2 ? String.join("", words)
                : String.join(", ", words.subList(0, words.size() - 1)) + " and " + words.get(words.size() - 1);
    }

    private void compareWeights() {
        if (b.length == 0) {
            return;
        }
        double[] expected = Arrays.copyOf(method.weights(), Math.max(b.length, method.stages()));
        double[] weights = Arrays.copyOf(b, expected.length);
        if (same(weights, expected) || b.length < method.stages() && same(b, Arrays.copyOf(expected, b.length))) {
            return;                                     // right, but for a stage that is missing and was named
        }
        String text = "the new state is " + Formula.state(step.kept(), weights, method.steps()) + "; "
                + method.authority()
                + " says "
                + Formula.state(1, expected, method.steps());
        String hint = weightHint(weights, expected);
        if (!hint.isEmpty()) {
            wrong(Finding.Kind.METHOD, text + hint);
            return;
        }
        List<Integer> wrong = IntStream.range(0, expected.length).filter(j -> !Formula.same(weights[j], expected[j]))
                .boxed()
                .toList();
        wrong(Finding.Kind.METHOD, text + ": the weight" + (wrong.size() == 1 ? "" : "s") + " of "
                + join(wrong.stream().map(this::slope).toList()) + (wrong.size() == 1 ? " is " : " are ")
                + join(wrong.stream().map(j -> Formula.number(weights[j])).toList()) + " instead of "
                + join(wrong.stream().map(j -> Formula.number(expected[j])).toList()));
    }

    private String weightHint(double[] weights, double[] expected) {
        int last = weights.length - 1;
        if (last > 0 && Math.abs(sum(weights)) == 0 && Arrays.stream(weights).allMatch(w -> w == 0)) {
            return ": no evaluation is in it; " + wholeNumbers(expected);
        }
        if (last > 0 && method.stages() == b.length && Formula.same(weights[last], 1) && Formula.same(sum(weights), 1)
                && expected[last] != 1) {
            return ": all of them are " + slope(last) + ", as if " + slope(0) + " to " + slope(last)
                    + " were one array, which each evaluation writes over";
        }
        if (last > 0 && a.length == weights.length && sum(a[last]) != 0 && same(weights, plus(expected, a[last]))) {
            return ": go back to the start s before taking the step; it was taken from the last trial state";
        }
        String factor = factorHint(weights, expected);
        if (!factor.isEmpty()) {
            return factor;
        }
        double total = sum(weights);
        return !Formula.same(total, 1) && total != 0 && same(Arrays.stream(weights).map(w -> w / total).toArray(),
                expected)
                ? ": all of it is " + Formula.number(total) + " times what it should be; the weights have to add up to "
                + "1" : "";
    }

    static boolean same(double[] x, double[] y) {
        for (int j = 0; j < x.length; j++) {
            if (!Formula.same(x[j], y[j])) {
                return false;
            }
        }
        return true;
    }

    static double sum(double[] x) {
        return Arrays.stream(x).sum();
    }

    private static double[] plus(double[] x, double[] y) {
        double[] sum = new double[x.length];
        Arrays.setAll(sum, j -> x[j] + y[j]);
        return sum;
    }
}
