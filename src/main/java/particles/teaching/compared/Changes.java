package particles.teaching.compared;

import deSolvers.DEStateSource;
import java.util.Arrays;
import java.util.function.BiFunction;
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
        return IntStream.rangeClosed(0, s.size()).boxed().flatMap(r -> others.apply(r).map(row -> s.with(r, row)));
    }

    /** @return the scheme in which the rows after the first one, up to before another one, are others */
    static Scheme rows(Scheme s, int to, BiFunction<Scheme, Integer, double[]> others) {
        Scheme changed = s;
        for (int r = 1; r < to; r++) {
            changed = changed.with(r, others.apply(changed, r));
        }
        return changed;
    }

    /** @return the schemes in which the increment of one row, of all trial states or of all rows is multiplied */
    static Stream<Scheme> increments(Scheme s, double factor) {
        return Stream.concat(each(s, r -> Stream.of(scaled(s.rows()[r], 1, 99, factor))), Stream.of(s.size(), s.size()
                + 1).map(to -> rows(s, to, (all, r) -> scaled(all.rows()[r], 1, 99, factor))));
    }

    /** @return these, and the schemes in which some weights of a row, or a kick or drift, are multiplied */
    static Stream<Scheme> multiplied(Scheme s, double factor) {
        int width = s.rows()[0].length;
        return Stream.of(increments(s, factor), each(s, r -> IntStream.range(0, width).boxed().flatMap(from -> Stream.of(
                from + 1, s.first() + s.size(), width).map(to -> scaled(s.rows()[r], from, to, factor)))), turns(s,
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

    /** @return the row with the weights of derivatives given to other evaluations */
    static double[] moved(Scheme s, int r, IntUnaryOperator to) {
        double[] row = s.rows()[r];
        double[] changed = scaled(row, s.first(), row.length, 0);
        for (int c = s.first(); c < row.length; c++) {
            int evaluation = (c - s.first()) % s.size();
            changed[c - evaluation + to.applyAsInt(evaluation)] += row[c];
        }
        return changed;
    }

    static double[] plus(double[] x, double[] y, double factor) {
        double[] sum = x.clone();
        Arrays.setAll(sum, c -> x[c] + factor * y[c]);
        return sum;
    }

    /** @return a row that begins at the state before and not at s */
    static double[] onwards(Scheme s, int r) {
        return plus(scaled(s.rows()[r], 0, 1, 0), s.rows()[r - 1], 1);
    }

    /** One kick or drift of turns, or all of them, are multiplied, and what comes later follows. */
    private static Stream<Scheme> turns(Scheme s, double factor) {
        if (!s.particles()) {
            return Stream.empty();
        }
        int n = s.size();
        double[] kicks = Arrays.copyOfRange(s.rows()[n], 2 + n, 2 + 2 * n);
        double[] drifts = IntStream.rangeClosed(0, n).mapToDouble(r -> s.rows()[r][1] - (r == 0 ? 0
                : s.rows()[r - 1][1])).toArray();
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
