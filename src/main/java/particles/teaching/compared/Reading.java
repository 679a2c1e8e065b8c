package particles.teaching.compared;

import deSolvers.DESolver;
import java.util.ArrayList;
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

/**
 * Reads the weights of a Runge-Kutta step by probes: the step is made with random numbers for the old state and the
 * derivatives, and again with one of them changed; what changes in a state is the weight of that number in it.
 */
public final class Reading {
    /** The largest number of evaluations in a step that is read. */
    private static final int MOST = 16;
    private static final double H = 0.2;
    private static final double START = 2;
    private static final int SIZE = 12;
    private static final int CHECKS = 3;
    private static final double ROUNDING = 1e-11;

    private Reading() {
    }

    /** The states of a step with these numbers: those of the evaluations, and the new one. */
    private record Run(Probe probe, List<double[]> states) {
        static Run of(DESolver solver, double h, double[][] numbers) {
            Probe probe = new Probe(numbers[0], START, j -> numbers[1 + j]);
            probe.step(solver, h);
            return new Run(probe, Stream.concat(probe.recorded().stream().map(Probe.Evaluation::state), Stream.of(
                    probe.getState())).toList());
        }
    }

    /** @return the weights and times of a step; empty if it is no sum with the same fixed weights for all entries */
    public static Optional<Scheme> of(Supplier<DESolver> maker) {
        try {
            Optional<Scheme> one = read(maker, H);
            return one.filter(scheme -> read(maker, 2 * H).filter(other -> other.unlike(scheme) < 0).isPresent()).map(
                    Reading::used);
        } catch (RuntimeException e) {                  // it refuses such numbers, or there are too few for it
            return Optional.empty();
        }
    }

    private static double[][] numbers(Random random) {
        return IntStream.rangeClosed(0, MOST).mapToObj(j -> random.doubles(SIZE, 0.5, 1.5).toArray()).toArray(
                double[][]::new);
    }

    private static Optional<Scheme> read(Supplier<DESolver> maker, double h) {
        Random random = new Random(715);
        double[][] numbers = numbers(random);
        Run run = Run.of(maker.get(), h, numbers);
        int n = run.states.size() - 1;
        List<double[]> rows = new ArrayList<>();
        for (int i = 0; i <= n; i++) {
            rows.add(new double[i + 1]);
        }
        for (int c = 0; c <= n; c++) {
            double[][] changed = numbers.clone();
            int one = c;
            changed[c] = IntStream.range(0, SIZE).mapToDouble(k -> numbers[one][k] + 1).toArray();
            Run other = Run.of(maker.get(), h, changed);
            if (other.states.size() != n + 1) {
                return Optional.empty();
            }
            for (int i = c; i <= n; i++) {
                rows.get(i)[c] = (other.states.get(i)[0] - run.states.get(i)[0]) / (changed[c][0] - numbers[c][0])
                        / (c == 0 ? 1 : h);
            }
        }
        double[] times = run.probe.recorded().stream().mapToDouble(at -> (at.time() - START) / h).toArray();
        Scheme scheme = new Scheme(rows, times, false);
        boolean same = Stream.generate(() -> numbers(random)).limit(CHECKS).allMatch(all -> {
            Run other = Run.of(maker.get(), h, all);
            return other.states.size() == n + 1 && IntStream.rangeClosed(0, n).allMatch(i -> IntStream.range(0, SIZE)
                    .allMatch(k -> Math.abs(IntStream.rangeClosed(0, i).mapToDouble(c -> rows.get(i)[c] * (c == 0 ? 1
                        : h) * all[c][k]).sum() - other.states.get(i)[k]) < ROUNDING));
        });
        return Optional.of(scheme).filter(found -> same && n > 0);
    }

    /** The same without a last evaluation that does not enter the new state, such as one kept for the next step. */
    private static Scheme used(Scheme scheme) {
        int n = scheme.size();
        double[] end = scheme.rows().get(n);
        if (n < 2 || !Formula.same(end[n], 0)) {
            return scheme;
        }
        List<double[]> rows = new ArrayList<>(scheme.rows().subList(0, n - 1));
        rows.add(Arrays.copyOf(end, n));
        return used(new Scheme(rows, Arrays.copyOf(scheme.times(), n - 1), false));
    }
}
