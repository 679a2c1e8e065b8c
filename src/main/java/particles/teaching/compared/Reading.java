package particles.teaching.compared;

import deSolvers.DESolver;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.function.IntPredicate;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.teaching.Formula;
import particles.teaching.declared.Scheme;
import particles.teaching.sources.Probe;
import particles.teaching.sources.Probe.Evaluation;

/**
 * Reads the weights of a Runge-Kutta step, or of particles that move in turns, by probes: the step is made with random
 * numbers for the old state and the derivatives, and again with one of them changed; what changes in a state is the
 * weight of that number in it.
 *
 * @param maker     makes a new solver
 * @param particles whether positions and velocities move in turns
 */
public record Reading(Supplier<DESolver> maker, boolean particles) {
    /** The largest number of evaluations in a step that is read. */
    private static final int MOST = 16;
    private static final double H = 0.2;
    private static final double START = 2;
    private static final int SIZE = 12;
    private static final double ROUNDING = 1e-11;

    /** @return the weights and times of a step; empty if it is no sum with the same fixed weights for all entries */
    public static Optional<Scheme> of(Supplier<DESolver> maker) {
        return Stream.of(false, true).flatMap(particles -> new Reading(maker, particles).scheme().stream()).findFirst();
    }

    private Optional<Scheme> scheme() {
        try {
            Random random = new Random(715);
            Scheme scheme = read(numbers(random));
            return Optional.of(scheme).filter(found -> found.size() > 0 && Stream.of(H, H, 2 * H, 2 * H).allMatch(h ->
                    isRight(scheme, h, numbers(random))));
        } catch (RuntimeException e) {                  // it refuses such numbers, or there are too few for it
            return Optional.empty();
        }
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

    /** Whether it makes the same step as the solver, but for trial velocities of particles. */
    private boolean isRight(Scheme scheme, double h, double[][] numbers) {
        List<Evaluation> own = probe(maker.get(), h, numbers);
        List<Evaluation> other = probe(scheme.solver(), h, numbers);
        return own.size() == other.size() && IntStream.range(0, own.size()).allMatch(j -> IntStream.range(0, SIZE)
                .allMatch(k -> particles && k % 6 > 2 && j < scheme.size() || Math.abs(own.get(j).state()[k] - other
                .get(j).state()[k]) < ROUNDING));
    }

    private Scheme read(double[][] numbers) {
        List<Evaluation> usual = probe(maker.get(), H, numbers);
        int n = usual.size() - 1;
        int first = particles ? 2 : 1;
        double[][] rows = new double[n + 1][first + (particles ? 2 * n : n)];
        for (int c = 0; c < first + n; c++) {           // the state, or positions and velocities; then derivatives
            int column = c;
            double[][] changed = numbers.clone();
            double[] one = numbers[Math.max(0, c - first + 1)].clone();
            Arrays.setAll(one, k -> one[k] + (column < first && particles && k / 3 % 2 != column ? 0 : 1));
            changed[Math.max(0, c - first + 1)] = one;
            List<Evaluation> other = probe(maker.get(), H, changed);
            for (int r = 0; r <= n; r++) {
                double[] more = Changes.plus(other.get(r).state(), usual.get(r).state(), -1);
                rows[r][c] = more[0] / (c == 0 ? 1 : c < 2 || !particles ? H : H * H);
                if (particles && c > 1 && r == n) {
                    rows[r][n + c] = more[3] / H;
                }
            }
        }
        return new Scheme(rows, usual.stream().limit(n).mapToDouble(at -> (at.time() - START) / H).toArray(),
                particles);
    }

    /** @return the same without a last evaluation that does not enter the new state, as one kept for the next step */
    public static Scheme used(Scheme scheme) {
        int n = scheme.size();
        double[][] rows = scheme.rows();
        IntPredicate last = c -> c >= scheme.first() && (c - scheme.first()) % n == n - 1;
        IntPredicate zero = c -> Formula.same(rows[n][c], 0);
        IntStream columns = IntStream.range(0, rows[n].length);
        return n < 2 || !columns.filter(last).allMatch(zero) ? scheme : used(new Scheme(IntStream.rangeClosed(0, n)
                .filter(r -> r != n - 1).mapToObj(r -> IntStream.range(0, rows[n].length).filter(last.negate())
                .mapToDouble(c -> rows[r][c]).toArray()).toArray(double[][]::new), Arrays.copyOf(scheme.times(), n - 1),
                scheme.particles()));
    }
}
