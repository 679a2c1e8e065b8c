package particles.teaching.solvers;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.function.BinaryOperator;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.teaching.Finding;
import particles.teaching.Formula;

/** A step that was read, compared with a known method: what differs, each in a sentence. */
final class Comparison {
    private static final double FLOAT_ROUNDING = 1e-6;
    /** A method is nearest to a known one where no more stages, times and weights differ. */
    private static final int FEW = 2;
    private static final Comparator<Comparison> NEAREST = Comparator.<Comparison>comparingInt(c -> c.distance)
            .thenComparingInt(c -> c.wrongWeights);

    /** What becomes of a row of weights by a mistake: from the right row and that of the evaluation before. */
    private enum Slip {
        FLOAT((right, before) -> right, FLOAT_ROUNDING, ": only the first seven digits are right, as in float"
                + " arithmetic; all numbers have to be double"),
        SIGN((right, before) -> times(-1, right), ": the sign is wrong"),
        DOUBLE((right, before) -> times(2, right), ": the half is missing"),
        HALF((right, before) -> times(0.5, right), ": it is halved once too often"),
        DOUBLE_BACK((right, before) -> times(-2, right), ": the sign is wrong"),
        NOT_BACK((right, before) -> Combination.sum(before) == 0 ? before : Combination.plus(right, 1, before),
                ": go back to the start s before adding (double[] trial = s makes no copy; s.clone() does)"),
        ONE_ARRAY((right, before) -> right.length < 3 ? times(0, right) : last(right), ": only the last derivative is"
                + " in it, as if all of them were one array, which each evaluation writes over"),
        ORDER((right, before) -> reversed(right), ": they are the other way round");

        private final BinaryOperator<double[]> change;
        private final double tolerance;
        private final String text;

        Slip(BinaryOperator<double[]> change, String text) {
            this(change, 1e-9, text);
        }

        Slip(BinaryOperator<double[]> change, double tolerance, String text) {
            this.change = change;
            this.tolerance = tolerance;
            this.text = text;
        }

        boolean makes(double[] found, double[] right, double[] before) {
            return Arrays.stream(Combination.plus(change.apply(right, before), -1, found)).allMatch(off ->
                    Math.abs(off) <= tolerance);
        }

        private static double[] times(double factor, double[] row) {
            return Arrays.stream(row).map(x -> factor * x).toArray();
        }

        private static double[] last(double[] row) {
            double[] last = new double[row.length];
            last[row.length - 1] = Combination.sum(row);
            return last;
        }

        private static double[] reversed(double[] row) {
            return IntStream.range(0, row.length).mapToDouble(j -> row[row.length - 1 - j]).toArray();
        }
    }

    private final Scheme known;
    private final Scheme found;
    private final boolean[] stateSet;
    private final List<Finding> findings = new ArrayList<>();
    private int unexplained;
    private int rounded;
    /** The differences, where another number of evaluations and another beginning count more. */
    private int distance;
    private int wrongWeights;

    private Comparison(Scheme known, Scheme found, boolean[] stateSet, boolean clocks) {
        this.known = known;
        this.found = found;
        this.stateSet = stateSet;
        compareSizes();
        int last = known.ends().size() - 1;
        if (last > 0) {                                 // the kicks, which the positions follow
            compare(found.ends().get(0), known.ends().get(0), found.size());
        }
        for (int i = 0; i < Math.min(found.size(), known.size()); i++) {
            compare(found.stages().get(i), known.stages().get(i), i);
        }
        if (clocks) {
            compareTimes();
        }
        compare(found.ends().get(last), known.ends().get(last), found.size());
    }

    /**
     * @param stateSet whether the state was set before each evaluation
     * @param clocks   whether the times can be compared
     * @return the comparison with the nearest of some methods
     */
    static Comparison nearest(List<Scheme> methods, Scheme found, boolean[] stateSet, boolean clocks) {
        return methods.stream().map(known -> new Comparison(known, found, stateSet, clocks)).min(NEAREST).orElseThrow();
    }

    Scheme known() {
        return known;
    }

    boolean isEmpty() {
        return findings.isEmpty();
    }

    /** @return whether little differs, or all of it by known mistakes */
    boolean isNear() {
        return findings.size() <= FEW || unexplained == 0;
    }

    /** @return whether the first seven digits of all weights are those of the method */
    boolean isRounded() {
        return rounded == findings.size();
    }

    /** @return the first difference */
    Finding first() {
        return findings.get(0);
    }

    private void wrong(Phrase phrase, Object... values) {
        Finding finding = phrase.of(values);
        findings.add(new Finding(finding.kind(), known.words(finding.text())));
        distance++;
    }

    private void compareSizes() {
        String source = known.isOfParticles() ? known.name() : known.source();
        int difference = found.size() - known.size();
        distance += known.isOfParticles() ? Math.abs(difference) : 0;
        unexplained += Math.abs(difference);
        for (int i = 0; i < Math.abs(difference); i++) {
            wrong(difference < 0 ? Phrase.MISSING : Phrase.TOO_MANY, calls(found.size()), source, calls(known.size()),
                    known.slope(found.size() + i), known.isOfParticles() ? ": the acceleration at the new position is"
                    + " missing" : "");
        }
    }

    private static String calls(int n) {
        return n == 1 ? "once" : n == 2 ? "twice" : n + " times";
    }

    /** Compares the row of a stage, or that of the new state after the last stage. */
    private void compare(Combination row, Combination right, int stage) {
        int n = Math.max(row.weights().length, right.weights().length);
        List<Integer> wrong = IntStream.range(0, n).filter(j -> !Formula.same(row.weight(j), right.weight(j))).boxed()
                .toList();
        boolean end = stage == found.size();
        boolean fewer = end && found.size() < known.size() && wrong.stream().allMatch(j -> j >= row.weights().length);
        if (wrong.isEmpty() || fewer) {                 // right, but for a stage that is missing and was named
            return;
        }
        String hint = hint(row, right, stage);
        unexplained += hint.isEmpty() ? 1 : 0;
        rounded += hint.equals(Slip.FLOAT.text) ? 1 : 0;
        distance += stage == 0 ? 2 : 0;
        wrongWeights += end ? wrong.size() : 0;
        if (end && hint.isEmpty() && n > 2) {
            int j = wrong.get(0);
            hint = ": the weight of " + known.slope(j - 1) + " is " + Formula.number(row.weight(j)) + " instead of "
                    + Formula.number(right.weight(j));
        }
        wrong(Phrase.DIFFERS, row.what(), row.formula(), known.source(), right.formula(), hint);
    }

    private String hint(Combination row, Combination right, int stage) {
        boolean end = stage == found.size();
        boolean position = row.names().get(0).equals("x");
        int first = position ? 2 : 1;
        int n = Math.max(row.weights().length, right.weights().length) - first;
        double[] weights = row.from(first, n);
        double[] expected = right.from(first, n);
        double[] before = stage == 0 || known.isOfParticles() ? new double[n]
                : found.stages().get(stage - 1).from(1, n);
        if (!end && stage > 0 && !stateSet[stage]) {
            return ": setState is missing before this getStateDerivative, so that it is " + (row.increment() == 0
                    ? "the derivative at the old state once more" : found.slope(stage - 1) + " again");
        }
        if (position && !Formula.same(row.weight(1), right.weight(1))) {
            return end ? ": the old velocity moves the position by " + Formula.number(row.weight(1)) + " v deltaT"
                    : row.increment() == 0 ? ": set the state with the new position before getStateDerivative" : "";
        }
        if (n > 0 && Combination.same(weights, new double[n]) && Combination.sum(expected) != 0) {
            return nothing(end || position ? "was left out" : "was not added to the state that is set", right);
        }
        for (Slip slip : Slip.values()) {
            if (slip.makes(weights, expected, before)) {
                return slip.text;
            }
        }
        double total = Combination.sum(weights) / Combination.sum(expected);
        return end && n > 1 && Math.abs(total) > 0 && Combination.same(weights, Slip.times(total, expected))
                ? ": all of it is " + Formula.number(total) + " times what it should be" : "";
    }

    /** Nothing tells a whole-number fraction from a part that was forgotten. */
    private static String nothing(String forgotten, Combination right) {
        String fraction = Arrays.stream(right.weights()).mapToObj(x -> Formula.number(Math.abs(x))).filter(number ->
                number.contains("/")).findFirst().orElse("");
        return ": no derivative is in it: it " + forgotten + (fraction.isEmpty() ? "" : ", or " + fraction
                + " is 0 in Java, as both are whole numbers, and " + fraction.replace("/", ".0/") + " is meant");
    }

    private void compareTimes() {
        List<Integer> wrong = IntStream.range(0, Math.min(found.size(), known.size())).filter(i ->
                !Formula.sameTime(found.times()[i], known.times()[i])).boxed().toList();
        if (!wrong.isEmpty()) {
            List<String> times = wrong.stream().map(i -> Formula.time(found.times()[i])).toList();
            boolean still = wrong.size() > 1 && wrong.stream().allMatch(i -> found.times()[i] == 0);
            unexplained += wrong.size();
            distance += wrong.size() > 1 ? 1 : 0;
            wrong(Phrase.STAGE_TIMES, join(wrong.stream().map(known::slope)) + (wrong.size() == 1 ? " is" : " are"),
                    times.stream().distinct().count() == 1 ? times.get(0) : join(times.stream()), known.source(),
                    join(wrong.stream().map(i -> Formula.time(known.times()[i]))), still ? ": the clock has to be moved"
                    + " with incTime before each evaluation, and not only at the end" : "");
        }
    }

    private static String join(Stream<String> all) {
        return String.join(", ", all.toList()).replaceFirst("(.*), ", "$1 and ");
    }
}
