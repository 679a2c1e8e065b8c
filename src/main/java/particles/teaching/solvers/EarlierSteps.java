package particles.teaching.solvers;

import deSolvers.DESolver;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import particles.teaching.Finding;
import particles.teaching.Formula;

/**
 * The weights of a multistep method, read from its seventh step: the new state is s + deltaT sum w_j f_j, with f_j an
 * evaluation of this step or of an earlier one, at the time t + c_j deltaT.
 *
 * @param weights w_j, the latest first; those of 0 left out
 * @param times   c_j
 */
record EarlierSteps(double[] weights, double[] times) {
    private static final int STEPS = 7;
    private static final double H = 1.0 / 16;
    private static final double SAME = 1e-9;
    private static final int HIGHEST = 6;

    /** @return the weights; empty if the new state is not the old one plus a sum of evaluations */
    static Optional<EarlierSteps> of(Supplier<DESolver> maker) {
        return StepReading.of(maker, H, 1, STEPS).filter(StepReading::isOneFormula).map(EarlierSteps::of)
                .filter(found -> found.weights.length > 0);
    }

    private static EarlierSteps of(StepReading step) {
        TreeMap<Double, Double> weights = new TreeMap<>(Comparator.reverseOrder());
        int n = step.evaluations();
        double[] before = step.positions()[n];
        for (int j = 0; j < n; j++) {
            double weight = (step.newPosition()[2 + j] - before[2 + j]) / H;
            if (Math.abs(weight) > SAME) {              // evaluated twice at a time: with a better state
                weights.merge(Math.rint(step.clock(j) * 1e9) / 1e9, weight, Double::sum);
            }
        }
        return new EarlierSteps(weights.values().stream().mapToDouble(w -> w).toArray(), weights.keySet().stream()
                .mapToDouble(t -> t).toArray());
    }

    /** @return the order of the formula: sum w_j c_j^q has to be 1/(q + 1) for all q below the order */
    int order() {
        int order = 0;
        while (order < HIGHEST && isIntegrated(order)) {
            order++;
        }
        return order;
    }

    private boolean isIntegrated(int power) {
        double sum = IntStream.range(0, weights.length).mapToDouble(j -> weights[j] * StrictMath.pow(times[j], power))
                .sum();
        return Math.abs(sum - 1.0 / (power + 1)) < SAME;
    }

    /**
     * @return the mistake in the weights, for a method of this number of evaluations; empty if their order is the
     *         highest possible
     */
    Optional<Finding> wrongWeights() {
        if (order() >= weights.length) {
            return Optional.empty();
        }
        double sum = Combination.sum(weights);
        return Optional.of(tooOld().orElseGet(() -> Phrase.ADAMS_WEIGHTS.of(numbers(weights), Math.abs(sum - 1) > SAME
                ? "add up to " + Formula.number(sum) + " and not to 1" : "make a method of order " + order(),
                numbers(adamsWeights(times)))));
    }

    /** The weights of an Adams method with derivatives of other times, as those kept are not shifted as they age. */
    private Optional<Finding> tooOld() {
        for (int count = weights.length; count <= HIGHEST; count++) {
            for (int latest = 0; latest < 2; latest++) {
                int newest = latest;
                double[] right = IntStream.range(0, count).mapToDouble(j -> newest - j).toArray();
                if (isGrouped(weights, adamsWeights(right))) {
                    return Optional.of(Phrase.ADAMS_OLD.of(count, clocks(times), clocks(right)));
                }
            }
        }
        return Optional.empty();
    }

    private static String clocks(double[] times) {
        return Arrays.stream(times).mapToObj(Formula::time).collect(Collectors.joining(", "));
    }

    /** Whether each weight is the sum of one or several neighbouring weights of a formula. */
    private static boolean isGrouped(double[] found, double[] formula) {
        int next = 0;
        for (double weight : found) {
            double sum = 0;
            do {
                if (next == formula.length) {
                    return false;
                }
                sum += formula[next++];
            } while (Math.abs(sum - weight) > SAME);
        }
        return next == formula.length;
    }

    /** The weights that integrate all polynomials of lower degree exactly, by Lagrange's polynomials. */
    private static double[] adamsWeights(double[] times) {
        int n = times.length;
        double[] right = new double[n];
        for (int j = 0; j < n; j++) {
            double[] polynomial = {1};
            for (int k = 0; k < n; k++) {
                if (k != j) {
                    double[] product = new double[polynomial.length + 1];
                    for (int q = 0; q < polynomial.length; q++) {
                        product[q] -= polynomial[q] * times[k] / (times[j] - times[k]);
                        product[q + 1] += polynomial[q] / (times[j] - times[k]);
                    }
                    polynomial = product;
                }
            }
            for (int q = 0; q < n; q++) {
                right[j] += polynomial[q] / (q + 1);
            }
        }
        return right;
    }

    /** @return the finding for first steps that are less accurate than the formula; empty if they are not */
    Optional<Finding> poorBeginning(double measured) {
        return order() >= 2 && measured < order() - 0.5 ? Optional.of(Phrase.ADAMS_START.of(order(),
                ExplicitMethod.twoDigits(measured), order() - 1)) : Optional.empty();
    }

    private static String numbers(double[] weights) {
        return List.of(Arrays.stream(weights).mapToObj(Formula::number).toArray()).stream().map(String::valueOf)
                .collect(Collectors.joining(", "));
    }
}
