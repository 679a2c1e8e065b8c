package particles.teaching.solvers;

import deSolvers.DESolver;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import particles.teaching.Finding;
import particles.teaching.Finding.Kind;
import particles.teaching.Formula;
import particles.teaching.sources.Probe;

/**
 * The weights of a multistep method, read from its seventh step as in {@link ExtractedTableau}: the new state is s +
 * deltaT sum w_j f_j, with f_j an evaluation of this step or of an earlier one, at the time t + c_j deltaT.
 *
 * @param weights w_j, by evaluation; those of 0 left out
 * @param times   c_j
 */
record MultistepReading(double[] weights, double[] times) {
    private static final int STEPS = 7;
    private static final double H = 1.0 / 16;
    private static final double SAME = 1e-9;
    private static final int HIGHEST = 6;

    /** @return the weights; empty if the new state is not the old one plus a sum of evaluations */
    static Optional<MultistepReading> of(Supplier<DESolver> maker) {
        int most = STEPS * Probe.MOST_EVALUATIONS;
        Probe probe = new Probe(new double[most + 2], 0, (evaluation, dSdt) -> dSdt[evaluation] = 1, most);
        DESolver solver = maker.get();
        double[] before = probe.state();
        double start = 0;
        try {
            for (int step = 0; step < STEPS; step++) {
                before = probe.state();
                start = probe.getTime();
                solver.stepState(probe, H);
            }
        } catch (RuntimeException e) {
            return Optional.empty();                    // it wants another source, or evaluates without end
        }
        double[] after = probe.state();
        List<Double> weights = new ArrayList<>();
        List<Double> times = new ArrayList<>();
        for (int j = 0; j < probe.recorded().size(); j++) {
            double weight = (after[j] - before[j]) / H;
            double time = (probe.recorded().get(j).time() - start) / H;
            if (Math.abs(weight) > SAME && times.contains(time)) {      // evaluated once more with a better state
                weights.set(times.indexOf(time), weights.get(times.indexOf(time)) + weight);
            } else if (Math.abs(weight) > SAME) {
                weights.add(weight);
                times.add(time);
            }
        }
        return weights.isEmpty() ? Optional.empty() : Optional.of(new MultistepReading(array(weights), array(times)));
    }

    private static double[] array(List<Double> list) {
        return list.stream().mapToDouble(x -> x).toArray();
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
        double sum = 0;
        for (int j = 0; j < weights.length; j++) {
            sum += weights[j] * StrictMath.pow(times[j], power);
        }
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
        Optional<Finding> stale = stale();
        if (stale.isPresent()) {
            return stale;
        }
        double sum = Arrays.stream(weights).sum();
        String formula = Arrays.stream(adamsWeights(times)).mapToObj(Formula::number).collect(Collectors.joining(", "));
        return Optional.of(new Finding(Kind.METHOD, "the weights of a step are " + text() + (Math.abs(sum - 1) > SAME
                ? ", which add up to " + Formula.number(sum) + " and not to 1" : ", which make a method of order "
                + order())
                + "; the Adams method with these evaluations has " + formula));
    }

    /** The weights of an Adams method with derivatives of other times, as those kept are not shifted as they age. */
    private Optional<Finding> stale() {
        int n = weights.length;
        Integer[] byAge = IntStream.range(0, n).boxed().sorted(Comparator.comparingDouble(j -> -times[j]))
                .toArray(Integer[]::new);
        double[] aged = Arrays.stream(byAge).mapToDouble(j -> weights[j]).toArray();
        List<String> found = Arrays.stream(byAge).map(j -> Formula.time(times[j])).toList();
        for (int count = n; count <= HIGHEST; count++) {
            for (int newest = 0; newest < 2; newest++) {
                int latest = newest;
                double[] right = IntStream.range(0, count).mapToDouble(j -> latest - j).toArray();
                if (isGrouped(aged, adamsWeights(right))) {
                    return Optional.of(new Finding(Kind.METHOD, "the weights are those of the Adams method of order "
                            + count + ", and its derivatives are those at " + String.join(", ", found) + " instead of "
                            + Arrays.stream(right).mapToObj(Formula::time).collect(Collectors.joining(", "))
                            + ": an old one is kept too long, or twice. In each step the oldest is dropped, then the"
                            + " others move by one place, the oldest of them first"));
                }
            }
        }
        return Optional.empty();
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

    /**
     * The weights that integrate all polynomials of lower degree exactly: a linear system, solved by Lagrange's
     * polynomials.
     */
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
            for (int q = 0; q < polynomial.length; q++) {
                right[j] += polynomial[q] / (q + 1);
            }
        }
        return right;
    }

    /** @return the finding for first steps that are less accurate than the formula; empty if they are not */
    Optional<Finding> poorBeginning(double measured) {
        return order() >= 2 && measured < order() - 0.5 ? Optional.of(new Finding(Kind.METHOD, "the formula has order "
                + order()
                + ", and the measured order is " + String.format(Locale.ROOT, "%.2f", measured)
                + ": the first steps, before there are"
                + " enough earlier derivatives, are not accurate enough. Begin with a method of order "
                + (order() - 1) + " or more, such as RK4")) : Optional.empty();
    }

    /** @return the weights, oldest evaluation first */
    private String text() {
        return Arrays.stream(weights).mapToObj(Formula::number).collect(Collectors.joining(", "));
    }
}
