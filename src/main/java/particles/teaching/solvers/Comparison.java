package particles.teaching.solvers;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import particles.teaching.Finding;
import particles.teaching.Formula;
import particles.teaching.contract.Phrase;

/**
 * A step that was read, compared with a known method: what differs, each in a sentence.
 *
 * @param step the reading of the found step
 */
record Comparison(Scheme known, Scheme found, StepReading step, List<Difference> differences) {
    private static final double FLOAT_ROUNDING = 1e-6;
    /** A method is nearest to a known one where no more stages, times and weights differ. */
    private static final int FEW = 2;
    /** What a difference counts; a wrong weight of the new state counts one more. */
    private static final int ONE = 100;

    private static final String FLOAT = ": only the first seven digits are right, as in float arithmetic; all numbers"
            + " have to be double";

    private static final Map<String, String> FACTORS = Map.of("-1", ": the sign is wrong", "2", ": the half is missing",
            "1/2", ": it is halved once too often", "-2", ": the sign is wrong, and the half is missing");

    /**
     * A difference.
     *
     * @param finding tells it; the nearest method's alone is asked for
     * @param hint    the known mistake behind it, after a colon; empty for none
     * @param cost    how far it takes the methods apart
     */
    record Difference(Supplier<Finding> finding, String hint, int cost) {
    }

    private Comparison(Scheme known, Scheme found, StepReading step) {
        this(known, found, step, new ArrayList<>());
        int more = found.size() - known.size();
        for (int i = 0; i < Math.abs(more); i++) {
            wrong(() -> (more < 0 ? Phrase.MISSING : Phrase.TOO_MANY).of(found.size(), known.source(), known.size(),
                    known.slope(found.size()), known.isOfParticles() ? ": the acceleration at the new position is"
                    + " missing" : ""), "", known.isOfParticles() ? 2 * ONE : ONE);
        }
        int last = known.ends().size() - 1;
        if (last > 0) {                                 // the kicks, which the positions follow
            compare(found.ends().get(0), known.ends().get(0), found.size());
        }
        if (more == 0 && known.isInTurn() && found.isInTurn()) {
            compare(found.drifts(), known.drifts(), found.size());
        } else {
            for (int i = 0; i < Math.min(found.size(), known.size()); i++) {
                compare(found.stages().get(i), known.stages().get(i), i);
            }
            compare(found.ends().get(last), known.ends().get(last), found.size());
        }
        if (step.isOnTime()) {
            compareTimes();
        }
    }

    /**
     * @param step the reading of the found step
     * @return the comparison with the nearest of some methods
     */
    static Comparison nearest(List<Scheme> methods, Scheme found, StepReading step) {
        return methods.stream().map(known -> new Comparison(known, found, step)).min(Comparator.comparingInt(one ->
                one.differences.stream().mapToInt(Difference::cost).sum())).orElseThrow();
    }

    /** @return whether little differs, or all of it by known mistakes */
    boolean isNear() {
        return differences.size() <= FEW || isNamed();
    }

    /** @return whether all of the differences are known mistakes */
    boolean isNamed() {
        return differences.stream().noneMatch(one -> one.hint.isEmpty());
    }

    /** @return whether the first seven digits of all weights are those of the method */
    boolean isRounded() {
        return differences.stream().allMatch(one -> one.hint.equals(FLOAT));
    }

    /** @return the first difference; empty if it is the method */
    Optional<Finding> first() {
        return differences.stream().findFirst().map(one -> one.finding.get()).map(finding -> new Finding(finding.kind(),
                known.words(finding.text())));
    }

    private void wrong(Supplier<Finding> finding, String hint, int cost) {
        differences.add(new Difference(finding, hint, cost));
    }

    /** Compares the row of a stage, or that of the new state after the last stage. */
    private void compare(Combination row, Combination right, int stage) {
        int[] wrong = row.unlike(right);
        boolean end = stage == found.size();
        if (wrong.length > 0 && !(end && wrong[0] >= row.weights().length)) {   // the stage that is missing was named
            String hint = hint(row, right, stage);
            wrong(() -> differs(row, right, known.source(), hint, end), hint, ONE + (stage == 0 ? 2 * ONE : 0) + (end
                    ? wrong.length : 0));
        }
    }

    /** @return the difference of a new state from that of a method with as many derivatives, if it is a near one */
    static Optional<Finding> near(Combination row, Combination right, String source) {
        int n = row.weights().length - row.first();
        String hint = change(row.slopes(n), right.slopes(n), new double[0]);
        return Optional.of(differs(row, right, source, hint, true)).filter(finding -> !hint.isEmpty() || row.unlike(
                right).length <= FEW);
    }

    private static Finding differs(Combination row, Combination right, String source, String hint, boolean end) {
        int worst = Arrays.stream(row.unlike(right)).filter(j -> end && j >= row.first()).findFirst().orElse(0);
        return Phrase.DIFFERS.of(row.what(), row.formula(), source, right.formula(), !hint.isEmpty() || worst < 1
                || right.weights().length < 3 ? hint : ": the weight of " + row.names().get(worst) + " is "
                + Formula.number(row.weight(worst)) + " instead of " + Formula.number(right.weight(worst)));
    }

    private String hint(Combination row, Combination right, int stage) {
        boolean end = stage == found.size();
        int n = Math.max(row.weights().length, right.weights().length) - row.first();
        double[] weights = row.slopes(n);
        double[] expected = right.slopes(n);
        if (!end && stage > 0 && !step.calls().recorded().get(stage).stateSet()) {
            return ": setState is missing before this getStateDerivative, so that it is " + (row.increment() == 0
                    ? "the derivative at the old state once more" : found.slope(stage - 1) + " again");
        }
        if (row.isPosition() && !Formula.same(row.weight(1), right.weight(1))) {
            return end ? ": the old velocity moves the position by " + Formula.number(row.weight(1)) + " v deltaT"
                    : row.increment() == 0 && row.weight(1) == 0
                    ? ": set the state with the new position before getStateDerivative" : "";
        }
        return n > 0 && Combination.same(weights, new double[n]) && Combination.sum(expected) != 0
                ? nothing(end || row.isPosition() ? "was left out" : "was not added to the state that is set", right)
                : change(weights, expected, stage == 0 || known.isOfParticles() || found.stages().get(0).increment()
                != 0 ? new double[n] : found.stages().get(stage - 1).slopes(n));
    }

    /**
     * @param before the weights of the state before, from which a state may go on by mistake
     * @return the named change that makes these weights of the right ones; empty if none does
     */
    private static String change(double[] weights, double[] expected, double[] before) {
        int n = expected.length;
        double total = Combination.sum(weights) / Combination.sum(expected);
        double[] last = new double[n];
        Arrays.setAll(last, j -> j < n - 1 ? 0 : Combination.sum(expected));
        return Combination.same(weights, expected, FLOAT_ROUNDING) ? FLOAT
                : Combination.same(weights, Combination.plus(new double[0], total, expected))
                ? FACTORS.getOrDefault(Formula.number(total), n > 1 ? ": all of it is " + Formula.number(total)
                + " times what it should be" : "")
                : Combination.same(weights, Combination.plus(expected, 1, before))
                ? ": go back to the start s before adding (double[] trial = s makes no copy; s.clone() does)"
                : n > 1 && Combination.same(weights, last) ? ": only the last derivative is in it, as if all of them"
                + " were one array, which each evaluation writes over"
                : Combination.same(weights, IntStream.range(0, n).mapToDouble(j -> expected[n - 1 - j]).toArray())
                ? ": the weights are the other way round" : "";
    }

    /** Nothing tells a whole-number fraction from a part that was forgotten. */
    private static String nothing(String forgotten, Combination right) {
        String fraction = Arrays.stream(right.weights()).mapToObj(x -> Formula.number(Math.abs(x))).filter(number ->
                number.contains("/")).findFirst().orElse("");
        return ": no derivative is in it: it " + forgotten + (fraction.isEmpty() ? "" : ", or " + fraction
                + " is 0 in Java, as both are whole numbers, and " + fraction.replace("/", ".0/") + " is meant");
    }

    private void compareTimes() {
        int[] wrong = IntStream.range(0, Math.min(found.size(), known.size())).filter(i -> Math.abs(
                found.times()[i] - known.times()[i]) > Combination.PRINTED).toArray();
        if (wrong.length > 0) {
            int i = wrong[0];
            wrong(() -> Phrase.STAGE_TIMES.of(known.slope(i), Formula.time(found.times()[i]), known.source(),
                    Formula.time(known.times()[i]), wrong.length > 1 && Arrays.stream(wrong).allMatch(j ->
                    found.times()[j] == 0) ? ": the clock has to be moved with incTime before each evaluation, and not"
                    + " only at the end" : ""), "", wrong.length > 1 ? 2 * ONE : ONE);
        }
    }
}
