package particles.teaching.solvers;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import particles.teaching.Finding;
import particles.teaching.Formula;

/** A step that was read, compared with a known method: what differs, each in a sentence. */
final class Comparison {
    private static final double FLOAT_ROUNDING = 1e-6;
    /** A method is nearest to a known one where no more stages, times and weights differ. */
    private static final int FEW = 2;
    private static final Comparator<Comparison> NEAREST = Comparator.<Comparison>comparingInt(c -> c.distance)
            .thenComparingInt(c -> c.wrongWeights);

    private static final String FLOAT = ": only the first seven digits are right, as in float arithmetic; all numbers"
            + " have to be double";

    private static final Map<String, String> FACTORS = Map.of("-1", ": the sign is wrong", "2", ": the half is missing",
            "1/2", ": it is halved once too often", "-2", ": the sign is wrong, and the half is missing");

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
            compare(found.ends().get(0), known.ends().get(0), 1, found.size());
        }
        if (known.size() == found.size() && known.isInTurn() && found.isInTurn()) {
            compare(found.drifts(), known.drifts(), 1, found.size());
        } else {
            for (int i = 0; i < Math.min(found.size(), known.size()); i++) {
                compare(found.stages().get(i), known.stages().get(i), 1 + last, i);
            }
            compare(found.ends().get(last), known.ends().get(last), 1 + last, found.size());
        }
        if (clocks) {
            compareTimes();
        }
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
        int more = found.size() - known.size();
        distance += known.isOfParticles() ? Math.abs(more) : 0;
        unexplained += Math.abs(more);
        for (int i = 0; i < Math.abs(more); i++) {
            wrong(more < 0 ? Phrase.MISSING : Phrase.TOO_MANY, found.size(), known.source(), known.size(), known.slope(
                    found.size()), known.isOfParticles() ? ": the acceleration at the new position is missing" : "");
        }
    }

    /** Compares the row of a stage, or that of the new state after the last stage. */
    private void compare(Combination row, Combination right, int first, int stage) {
        int n = Math.max(row.weights().length, right.weights().length);
        int[] wrong = IntStream.range(0, n).filter(j -> !Formula.same(row.weight(j), right.weight(j))).toArray();
        boolean end = stage == found.size();
        if (wrong.length == 0 || end && wrong[0] >= row.weights().length) {
            return;                                     // right, but for a stage that is missing and was named
        }
        String hint = hint(row, right, first, stage);
        unexplained += hint.isEmpty() ? 1 : 0;
        rounded += hint.equals(FLOAT) ? 1 : 0;
        distance += stage == 0 ? 2 : 0;
        wrongWeights += end ? wrong.length : 0;
        int worst = Arrays.stream(wrong).filter(j -> j >= first).findFirst().orElse(0);
        if (end && hint.isEmpty() && n > 2 && worst > 0) {
            hint = ": the weight of " + row.names().get(worst) + " is " + Formula.number(row.weight(worst))
                    + " instead of " + Formula.number(right.weight(worst));
        }
        wrong(Phrase.DIFFERS, row.what(), row.formula(), known.source(), right.formula(), hint);
    }

    private String hint(Combination row, Combination right, int first, int stage) {
        boolean end = stage == found.size();
        boolean position = first == 2;
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
        double total = Combination.sum(weights) / Combination.sum(expected);
        double[] last = new double[n];
        last[n - 1] = Combination.sum(expected);
        return Combination.same(weights, expected, FLOAT_ROUNDING) ? FLOAT
                : Combination.same(weights, Combination.plus(new double[0], total, expected))
                ? FACTORS.getOrDefault(Formula.number(total), end && n > 1 ? ": all of it is " + Formula.number(total)
                + " times what it should be" : "")
                : Combination.same(weights, Combination.sum(before) == 0 ? before : Combination.plus(expected, 1,
                before))
                ? ": go back to the start s before adding (double[] trial = s makes no copy; s.clone() does)"
                : n > 2 && Combination.same(weights, last) ? ": only the last derivative is in it, as if all of them"
                + " were one array, which each evaluation writes over"
                : Combination.same(weights, IntStream.range(0, n).mapToDouble(j -> expected[n - 1 - j]).toArray())
                ? ": they are the other way round" : "";
    }

    /** Nothing tells a whole-number fraction from a part that was forgotten. */
    private static String nothing(String forgotten, Combination right) {
        String fraction = Arrays.stream(right.weights()).mapToObj(x -> Formula.number(Math.abs(x))).filter(number ->
                number.contains("/")).findFirst().orElse("");
        return ": no derivative is in it: it " + forgotten + (fraction.isEmpty() ? "" : ", or " + fraction
                + " is 0 in Java, as both are whole numbers, and " + fraction.replace("/", ".0/") + " is meant");
    }

    private void compareTimes() {
        int[] wrong = IntStream.range(0, Math.min(found.size(), known.size())).filter(i -> !Formula.sameTime(
                found.times()[i], known.times()[i])).toArray();
        if (wrong.length > 0) {
            int i = wrong[0];
            unexplained += wrong.length;
            distance += wrong.length > 1 ? 1 : 0;
            wrong(Phrase.STAGE_TIMES, known.slope(i), Formula.time(found.times()[i]), known.source(), Formula.time(
                    known.times()[i]), wrong.length > 1 && Arrays.stream(wrong).allMatch(j -> found.times()[j] == 0)
                    ? ": the clock has to be moved with incTime before each evaluation, and not only at the end" : "");
        }
    }
}
