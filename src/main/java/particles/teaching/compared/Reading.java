package particles.teaching.compared;

import deSolvers.DESolver;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.teaching.Formula;
import particles.teaching.declared.Scheme;
import particles.teaching.sources.Probe;
import particles.teaching.sources.Probe.Evaluation;
import particles.teaching.sources.StudentSource;

/**
 * Reads the weights of a Runge-Kutta step by probes: the step is made with random numbers for the old state and the
 * derivatives, and again with one of them changed; what changes in a state is the weight of that number in it.
 */
public final class Reading {
    /** The largest number of evaluations in a step that is read. */
    private static final int MOST = 16;
    private static final List<Double> LENGTHS = List.of(0.2, 0.4);
    private static final double START = 2;
    private static final int SIZE = 12;
    private static final int CHECKS = 2;
    private static final double ROUNDING = 1e-11;

    private Reading() {
    }

    /** @return the weights and times of a step; empty if it is no sum with the same fixed weights for all entries */
    public static Optional<Scheme> of(Supplier<DESolver> maker) {
        try {
            Random random = new Random(715);
            Scheme scheme = read(maker, LENGTHS.get(0), numbers(random));
            return Optional.of(scheme).filter(found -> found.size() > 0 && LENGTHS.stream().allMatch(h -> Stream
                    .generate(() -> numbers(random)).limit(CHECKS).allMatch(numbers -> isAlike(probe(maker.get(), h,
                    numbers), probe(scheme.solver(), h, numbers))))).map(Reading::used);
        } catch (RuntimeException e) {                  // it refuses such numbers, or there are too few for it
            return Optional.empty();
        }
    }

    /** The same without a last evaluation that does not enter the new state, such as one kept for the next step. */
    private static Scheme used(Scheme scheme) {
        int n = scheme.size();
        double[][] rows = scheme.rows();
        return n < 2 || !Formula.same(rows[n][n], 0) ? scheme : used(new Scheme(IntStream.rangeClosed(0, n).filter(r ->
                r != n - 1).mapToObj(r -> Arrays.copyOf(rows[r], n)).toArray(double[][]::new), Arrays.copyOf(
                scheme.times(), n - 1), false));
    }

    private static double[][] numbers(Random random) {
        return IntStream.rangeClosed(0, MOST).mapToObj(j -> random.doubles(SIZE, 0.5, 1.5).toArray()).toArray(
                double[][]::new);
    }

    /** The evaluations of a step with these numbers, and at last the new state. */
    private static List<Evaluation> probe(DESolver solver, double h, double[][] numbers) {
        Probe probe = new Probe(numbers[0], START, j -> numbers[1 + j]);
        probe.step(solver, h);
        return Stream.concat(probe.recorded().stream(), Stream.of(new Evaluation(probe.getState(), probe.getTime())))
                .toList();
    }

    private static boolean isAlike(List<Evaluation> own, List<Evaluation> other) {
        return own.size() == other.size() && IntStream.range(0, own.size()).allMatch(j -> StudentSource.distance(own
                .get(j).state(), other.get(j).state()) < ROUNDING);
    }

    private static Scheme read(Supplier<DESolver> maker, double h, double[][] numbers) {
        List<Evaluation> usual = probe(maker.get(), h, numbers);
        int n = usual.size() - 1;
        double[][] rows = new double[n + 1][n + 1];
        for (int c = 0; c <= n; c++) {
            double[][] changed = numbers.clone();
            changed[c] = Arrays.stream(numbers[c]).map(x -> x + 1).toArray();
            List<Evaluation> other = probe(maker.get(), h, changed);
            for (int r = c; r <= n; r++) {
                rows[r][c] = (other.get(r).state()[0] - usual.get(r).state()[0]) / (c == 0 ? 1 : h);
            }
        }
        return new Scheme(rows, usual.stream().limit(n).mapToDouble(at -> (at.time() - START) / h).toArray(), false);
    }
}
