package particles.teaching.solvers;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import particles.teaching.Finding;
import particles.teaching.Formula;

/** What sets coefficients that were read off apart from those of a known method, each in a sentence. */
final class MethodDifferences {
    private final KnownMethod method;
    private final double[][] a;
    private final double[] b;
    private final double[] c;
    private final ExtractedTableau step;
    private final List<Finding> found = new ArrayList<>();

    private MethodDifferences(KnownMethod method, double[][] a, double[] b, double[] c, ExtractedTableau step) {
        this.method = method;
        this.a = a;
        this.b = b;
        this.c = c;
        this.step = step;
    }

    /**
     * @param method  what it is compared with
     * @param a       the rows, in units of deltaT
     * @param b       the weights, in units of deltaT; empty if they tell nothing
     * @param c       the clocks, in units of deltaT; empty if they tell nothing
     * @param step    the step that all was read off
     * @return the differences; none if it is this method
     */
    static List<Finding> of(KnownMethod method, double[][] a, double[] b, double[] c, ExtractedTableau step) {
        MethodDifferences differences = new MethodDifferences(method, a, b, c, step);
        differences.compareStages();
        differences.compareClocks();
        differences.compareWeights();
        return differences.found;
    }

    private void wrong(Finding.Kind kind, String text) {
        found.add(new Finding(kind, text));
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
            wrong(Finding.Kind.METHOD, "there is an evaluation too many: getStateDerivative is called " + times(a.length) + ", "
                    + method.authority() + " needs " + times(method.stages()));
        }
        for (int i = 0; i < Math.min(a.length, method.stages()); i++) {
            double[] expected = Arrays.copyOf(method.row(i), a.length);
            if (!same(a[i], expected)) {
                wrong(Finding.Kind.METHOD, slope(i) + " is evaluated at " + Formula.state(1, a[i], method.steps()) + "; "
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
            return ": nothing is added to s; 1/2 is 0 in Java, as both are whole numbers, and 0.5 is meant";
        }
        if (i > 0 && same(a[i], plus(expected, a[i - 1]))) {
            return ": go back to the start s before adding";
        }
        return factorHint(a[i], expected);
    }

    /** A row that is a multiple of the right one. */
    private static String factorHint(double[] found, double[] expected) {
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
            if (!Formula.same(c[i], method.tableau().node(i))) {
                wrong.add(i);
            }
        }
        boolean neverMoved = wrong.size() > 1 && wrong.stream().allMatch(i -> c[i] == 0);
        if (neverMoved) {
            wrong(Finding.Kind.TIME, join(wrong.stream().map(this::slope).toList()) + " are evaluated at t; "
                    + method.authority() + " says "
                    + join(wrong.stream().map(i -> Formula.time(method.tableau().node(i))).toList())
                    + ": the clock has to be moved with incTime before each evaluation, and not only at the end");
            return;
        }
        for (int i : wrong) {
            wrong(Finding.Kind.TIME, slope(i) + " is evaluated at " + Formula.time(c[i]) + "; " + method.authority() + " says "
                    + Formula.time(method.tableau().node(i)));
        }
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
        String text = "the new state is " + Formula.state(step.kept(), weights, method.steps()) + "; " + method.authority()
                + " says "
                + Formula.state(1, expected, method.steps());
        String hint = weightHint(weights, expected);
        if (!hint.isEmpty()) {
            wrong(Finding.Kind.METHOD, text + hint);
            return;
        }
        for (int j = 0; j < expected.length; j++) {     // one finding a weight, so that the nearest method is the one with the fewest
            if (!Formula.same(weights[j], expected[j])) {
                wrong(Finding.Kind.METHOD, text + ": the weight of " + slope(j) + " is " + Formula.number(weights[j])
                        + " instead of "
                        + Formula.number(expected[j]));
            }
        }
    }

    private String weightHint(double[] weights, double[] expected) {
        int last = weights.length - 1;
        if (last > 0 && Math.abs(sum(weights)) == 0 && Arrays.stream(weights).allMatch(w -> w == 0)) {
            return ": no evaluation is in it; 1/6 is 0 in Java, as both are whole numbers, and 1.0/6 is meant";
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
        return !Formula.same(total, 1) && total != 0 && same(Arrays.stream(weights).map(w -> w / total).toArray(), expected)
                ? ": all of it is " + Formula.number(total) + " times what it should be; the weights have to add up to 1" : "";
    }

    static boolean same(double[] x, double[] y) {
        for (int j = 0; j < x.length; j++) {
            if (!Formula.same(x[j], y[j])) {
                return false;
            }
        }
        return true;
    }

    /** @return whether each stage is where its time leads */
    static boolean isConsistent(double[][] rows, double[] clocks) {
        for (int i = 0; i < rows.length; i++) {
            if (!Formula.same(sum(rows[i]), clocks[i])) {
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
