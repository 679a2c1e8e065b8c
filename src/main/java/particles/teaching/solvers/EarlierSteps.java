package particles.teaching.solvers;

import deSolvers.DESolver;
import java.util.Arrays;
import java.util.Comparator;
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

    /** @return the weights; empty if the new state is not the old one plus a sum of evaluations */
    static Optional<EarlierSteps> of(Supplier<DESolver> maker) {
        return StepReading.of(maker, H, 1, STEPS).filter(reading -> !reading.isOfParticles()).map(EarlierSteps::of)
                .filter(found -> found.weights.length > 0);
    }

    private static EarlierSteps of(StepReading step) {
        TreeMap<Double, Double> weights = new TreeMap<>(Comparator.reverseOrder());
        int n = step.evaluations();
        double[][] rows = step.rows();
        for (int j = 0; j < n; j++) {
            double weight = rows[n + 1][1 + j] - rows[n][1 + j];
            if (Math.abs(weight) > SAME) {              // evaluated twice at a time: with a better state
                weights.merge(Math.rint(step.clock(j) * 1e9) / 1e9, weight, Double::sum);
            }
        }
        return new EarlierSteps(weights.values().stream().mapToDouble(w -> w).toArray(), weights.keySet().stream()
                .mapToDouble(t -> t).toArray());
    }

    /** @return the mistake in the weights; empty if their order is the highest possible, one for each */
    Optional<Finding> wrongWeights() {
        if (Combination.same(weights, adamsWeights(times))) {
            return Optional.empty();
        }
        double[] right = IntStream.range(0, times.length).mapToDouble(j -> times[0] - j).toArray();
        double sum = Combination.sum(weights);
        return Optional.of(Combination.same(weights, adamsWeights(right))
                ? Phrase.ADAMS_OLD.of(numbers(weights), clocks(times), clocks(right))
                : Phrase.ADAMS_WEIGHTS.of(numbers(weights), clocks(times), Formula.same(sum, 1) ? ""
                : ", which add up to " + Formula.number(sum) + " and not to 1", numbers(adamsWeights(times))));
    }

    private static String clocks(double[] times) {
        return Arrays.stream(times).mapToObj(Formula::time).collect(Collectors.joining(", "));
    }

    /** The weights that integrate all polynomials of lower degree exactly. */
    private static double[] adamsWeights(double[] times) {
        double[][] powers = new double[times.length][times.length];
        double[] integrals = new double[times.length];
        for (int q = 0; q < times.length; q++) {
            integrals[q] = 1.0 / (q + 1);
            for (int j = 0; j < times.length; j++) {
                powers[j][q] = StrictMath.pow(times[j], q);
            }
        }
        return LeastSquares.weights(powers, integrals)[0];
    }

    /** @return the finding for first steps that are less accurate than the formula; empty if they are not */
    Optional<Finding> poorBeginning(double measured) {
        int order = weights.length;
        boolean adams = Combination.same(weights, adamsWeights(times));
        return Phrase.ADAMS_START.when(adams && order >= 2 && measured < order - 0.5, order, ExplicitMethod.twoDigits(
                measured), order - 1);
    }

    private static String numbers(double[] weights) {
        return Arrays.stream(weights).mapToObj(Formula::number).collect(Collectors.joining(", "));
    }
}
