package particles.teaching.compared;

import deSolvers.DEStateSource;
import java.util.Arrays;
import java.util.function.IntFunction;
import java.util.function.IntPredicate;
import java.util.function.IntUnaryOperator;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.teaching.declared.Scheme;
import particles.teaching.declared.Step;

/** Changes of a method's weights and steps, of which the typical mistakes are made. */
final class Changes {
    private Changes() {
    }

    /** @return the schemes in which one row is another */
    static Stream<Scheme> each(Scheme s, IntFunction<Stream<double[]>> others) {
        return IntStream.range(0, s.rows().size()).boxed().flatMap(r -> others.apply(r).map(row -> s.with(r, row)));
    }

    /** @return the scheme in which the rows before one are others */
    static Scheme rows(Scheme s, int to, IntFunction<double[]> others) {
        Scheme changed = s;
        for (int r = 1; r < to; r++) {
            changed = changed.with(r, others.apply(r));
        }
        return changed;
    }

    /** @return the schemes in which the increment of one row, of all trial states or of all rows is multiplied */
    static Stream<Scheme> increments(Scheme s, double factor) {
        IntFunction<double[]> row = r -> scaled(s.rows().get(r), s.own(r) + 1, 99, factor);
        return Stream.concat(each(s, r -> Stream.of(row.apply(r))), Stream.of(rows(s, s.size(), row), rows(s, s.rows()
                .size(), row)));
    }

    /** @return these, and the schemes in which one weight, it and all after it, or a kick or drift is multiplied */
    static Stream<Scheme> multiplied(Scheme s, double factor) {
        return Stream.of(increments(s, factor), each(s, r -> IntStream.range(s.own(r), s.rows().get(r).length).boxed()
                .flatMap(c -> Stream.of(c + 1, 99).map(to -> scaled(s.rows().get(r), c, to, factor)))), turns(s,
                factor)).flatMap(schemes -> schemes);
    }

    /** @return the row with the weights from a column to before another one multiplied */
    static double[] scaled(double[] row, int from, int to, double factor) {
        double[] changed = row.clone();
        for (int c = from; c < Math.min(to, row.length); c++) {
            changed[c] *= factor;
        }
        return changed;
    }

    static Stream<Integer> columns(Scheme s, int r) {
        return IntStream.range(s.first(), s.first() + Math.min(r, s.size())).boxed();
    }

    /** @return the row with the weights of derivatives in other columns */
    static double[] moved(Scheme s, int r, IntUnaryOperator to) {
        double[] row = s.rows().get(r);
        double[] changed = Arrays.copyOf(row, Math.max(row.length, s.first() + Math.min(r, s.size())));
        Arrays.fill(changed, Math.min(s.first(), row.length), changed.length, 0);
        for (int c = s.first(); c < row.length; c++) {
            changed[to.applyAsInt(c)] += row[c];
        }
        return changed;
    }

    static double[] plus(double[] x, double[] y, double factor) {
        double[] sum = Arrays.copyOf(x, Math.max(x.length, y.length));
        IntStream.range(0, y.length).forEach(c -> sum[c] += factor * y[c]);
        return sum;
    }

    /** @return a row that begins at another state */
    static double[] from(Scheme s, int r, double[] begin) {
        double[] row = s.rows().get(r);
        return plus(scaled(row, s.own(r), s.own(r) + 1, 0), begin, r > s.size() ? 0 : 1);
    }

    /** @return the scheme whose rows before one each begin at the one before */
    static Scheme onAndOn(Scheme s, int to) {
        Scheme changed = s;
        for (int r = 1; r < to; r++) {
            changed = changed.with(r, from(s, r, changed.rows().get(r - 1)));
        }
        return changed;
    }

    /** One kick or drift of turns, or all of them, are multiplied, and what comes later follows. */
    private static Stream<Scheme> turns(Scheme s, double factor) {
        if (!s.particles()) {
            return Stream.empty();
        }
        double[] kicks = Arrays.copyOfRange(s.rows().get(s.size() + 1), 2, 2 + s.size());
        double[] drifts = IntStream.rangeClosed(0, s.size()).mapToDouble(r -> s.rows().get(r)[1] - (r == 0 ? 0
                : s.rows().get(r - 1)[1])).toArray();
        return IntStream.range(0, drifts.length).boxed().flatMap(j -> Stream.of(j + 1, 99).flatMap(to -> Stream.of(
                Scheme.turns(drifts, scaled(kicks, j, to, factor)), Scheme.turns(scaled(drifts, j, to, factor),
                kicks))));
    }

    /** The clock is at the start, in the middle or at the end in one evaluation, or in all of them. */
    static Stream<Scheme> clocks(Scheme s) {
        return Stream.of(0.0, 0.5, 1.0).flatMap(t -> IntStream.rangeClosed(0, s.size()).mapToObj(j -> {
            double[] times = s.times().clone();
            Arrays.fill(times, j == s.size() ? 0 : j, Math.min(j + 1, s.size()), t);
            return s.at(times);
        }));
    }

    /** @return the steps of groups of entries, one after the other, or each from the start */
    static Stream<Step> inTurn(Step step, IntUnaryOperator group) {
        return Stream.of(false, true).map(fromStart -> (source, deltaT) -> {
            double t = source.getTime();
            double[] start = state(source);
            double[] end = start.clone();
            int groups = IntStream.range(0, end.length).map(group).max().orElse(0);
            for (int g = 0; g <= groups; g++) {
                int mine = g;
                source.incTime(t - source.getTime());
                step.make(new Part(source, state(source), k -> group.applyAsInt(k) == mine), deltaT);
                double[] reached = state(source);
                IntStream.range(0, end.length).filter(k -> group.applyAsInt(k) == mine).forEach(k -> end[k]
                        = reached[k]);
                source.setState(fromStart ? start : end);
            }
            source.setState(end);
        });
    }

    /** @return the step, but for the position: x + v deltaT, v between the old and the new one, + half a deltaT^2 */
    static Step drifted(Step step, double newer, double half) {
        return (source, deltaT) -> {
            double[] start = state(source);
            double[] dSdt = new double[start.length];
            source.getStateDerivative(dSdt);
            step.make(source, deltaT);
            double[] end = state(source);
            for (int k = 0; k < end.length; k += k % 6 == 2 ? 4 : 1) {
                end[k] = start[k] + deltaT * ((1 - newer) * start[k + 3] + newer * end[k + 3] + half * deltaT
                        * dSdt[k + 3]);
            }
            source.setState(end);
        };
    }

    private static double[] state(DEStateSource source) {
        double[] state = new double[source.getStateSize()];
        source.getState(state);
        return state;
    }

    /**
     * A source of which some entries move alone.
     *
     * @param source the whole source
     * @param others the state in which the others stand still
     * @param moves  tells which move
     */
    private record Part(DEStateSource source, double[] others, IntPredicate moves) implements DEStateSource {
        @Override
        public int getStateSize() {
            return others.length;
        }

        @Override
        public void getState(double[] state) {
            source.getState(state);
        }

        @Override
        public void setState(double[] state) {
            double[] all = others.clone();
            IntStream.range(0, all.length).filter(moves).forEach(k -> all[k] = state[k]);
            source.setState(all);
        }

        @Override
        public void getStateDerivative(double[] dSdt) {
            source.getStateDerivative(dSdt);
            Arrays.setAll(dSdt, k -> moves.test(k) ? dSdt[k] : 0);
        }

        @Override
        public double getTime() {
            return source.getTime();
        }

        @Override
        public void incTime(double deltaT) {
            source.incTime(deltaT);
        }
    }
}
