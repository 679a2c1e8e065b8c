package particles.teaching.compared;

import deSolvers.DEStateSource;
import java.util.Arrays;
import java.util.function.BiFunction;
import java.util.function.IntFunction;
import java.util.function.IntPredicate;
import java.util.function.IntUnaryOperator;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.teaching.declared.Equation;
import particles.teaching.declared.Scheme;
import particles.teaching.declared.Step;

/** Changes of a method's weights and steps, of which the typical mistakes are made. */
final class Changes {
    /** The place of the state before the first of six steps. */
    private static final double FIRST = -5;

    private Changes() {
    }

    /**
     * Changes that are none of weights.
     *
     * @param steps makes them of a step and the size of the state
     */
    record Split(BiFunction<Step, Integer, Stream<Step>> steps) {
    }

    static Split split(BiFunction<Step, Integer, Stream<Step>> steps) {
        return new Split(steps);
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
    static Stream<Scheme> eachAndAll(Scheme s, double factor) {
        IntFunction<double[]> row = r -> scaled(s.rows().get(r), s.own(r) + 1, 99, factor);
        return Stream.concat(each(s, r -> Stream.of(row.apply(r))), Stream.of(rows(s, s.size(), row), rows(s, s.rows()
                .size(), row)));
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

    static double[] alike(double[] row, int first) {
        double[] changed = row.clone();
        for (int c = first; c < row.length; c++) {
            changed[c] = Arrays.stream(row).skip(first).average().orElseThrow();
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

    /** States, s + k or those of the stages, are taken where k is meant. */
    static Stream<Scheme> ofStates(Scheme s, double h) {
        if (s.particles()) {
            return Stream.empty();
        }
        int n = s.size();
        double[] end = s.rows().get(n);
        double[] mean = {0};
        for (int j = 0; j < n; j++) {
            mean = plus(mean, s.rows().get(j), end[1 + j]);
        }
        double[] states = mean;
        IntFunction<double[]> own = r -> plus(s.rows().get(r), new double[] {1}, Scheme.sum(s.rows().get(r)) - 1);
        return Stream.concat(Stream.of(1, 0).flatMap(kept -> Stream.of(1, h).map(factor -> s.with(n, plus(new double[] {
            kept}, states, factor.doubleValue())))), Stream.of(s.with(n, own.apply(n)), rows(s, n, own), rows(s, n + 1,
                own)));
    }

    /** One kick or drift of turns is another, and the later ones follow it. */
    static Stream<Scheme> turns(Scheme s, double h) {
        if (!s.particles()) {
            return Stream.empty();
        }
        double[] kicks = Arrays.copyOfRange(s.rows().get(s.size() + 1), 2, 2 + s.size());
        double[] drifts = IntStream.rangeClosed(0, s.size()).mapToDouble(r -> s.rows().get(r)[1] - (r == 0 ? 0
                : s.rows().get(r - 1)[1])).toArray();
        return Stream.of(-1.0, 0.0, 0.5, 2.0).flatMap(factor -> Stream.concat(IntStream.range(0, kicks.length).mapToObj(
                j -> Scheme.turns(drifts, scaled(kicks, j, j + 1, factor))), Stream.concat(IntStream.range(0,
                drifts.length).mapToObj(j -> Scheme.turns(scaled(drifts, j, j + 1, factor), kicks)), Stream.of(
                Scheme.turns(drifts, scaled(kicks, 0, 99, factor)), Scheme.turns(scaled(drifts, 0, 99, factor),
                kicks)))));
    }

    /** The clock is early or late at one evaluation, or adds up what is meant to be since the start. */
    static Stream<Scheme> clocks(Scheme s, double h) {
        double[] sums = s.times().clone();
        Arrays.parallelPrefix(sums, Double::sum);
        Stream<double[]> one = IntStream.range(0, s.size()).boxed().flatMap(j -> Stream.of(0.0, 0.5, 1.0,
                2 * s.times()[j], s.times()[j] / 2).map(t -> {
                    double[] times = s.times().clone();
                    times[j] = t;
                    return times;
                }));
        Stream<double[]> all = Stream.of(0.5, 1.0).flatMap(t -> Stream.of(IntStream.range(0, s.size()).mapToDouble(j ->
                t * j).toArray(), Arrays.stream(s.times()).map(c -> c == 0 ? 0 : t).toArray(), Arrays.stream(s.times())
                .map(c -> t).toArray()));
        return Stream.of(Stream.of(sums), one, all).flatMap(times -> times).map(s::at);
    }

    /** @return the typical mistakes in an equation */
    static Stream<Equation> ofEquation(Equation right) {
        double[] states = right.states();
        double[] places = right.places();
        double[] clocks = right.clocks();
        double[] rates = right.rates();
        boolean implicit = right.isImplicit();
        Stream<double[]> clock = implicit ? IntStream.range(0, clocks.length).boxed().flatMap(j -> Stream.of(0.0, 0.5,
                1.0).map(t -> put(clocks, j, t))) : Stream.empty();
        Stream<double[]> rate = Stream.concat(Stream.of(-1.0, 0.5, 2.0, 1 / Scheme.sum(rates)).map(factor ->
                scaled(rates, 0, 99, factor)), IntStream.range(0, rates.length).boxed().flatMap(j -> Stream.of(-1.0,
                0.0, 0.5, 2.0, 1 / rates[j]).map(factor -> scaled(rates, j, j + 1, factor))));
        Stream<double[]> state = IntStream.range(0, states.length).mapToObj(j -> scaled(states, j, j + 1, -1));
        Stream<double[]> place = !right.usesEarlier() ? Stream.empty() : IntStream.range(0, places.length).boxed()
                .flatMap(j -> Stream.of(places[j] - 1, places[j] + 1, implicit ? places[j] : FIRST).map(other ->
                put(places, j, other)));
        return Stream.of(clock.map(c -> new Equation(states, places, c, rates)),
                rate.map(w -> new Equation(states, places, clocks, w)),
                Stream.of(new Equation(states, places, clocks, reversed(rates)),
                        new Equation(reversed(states), places, clocks, rates)),
                state.map(a -> new Equation(a, places, clocks, rates)),
                place.map(p -> new Equation(states, p, p, rates)),
                Stream.of(new Equation(states, new double[places.length], clocks, rates)).filter(one -> !implicit))
                .flatMap(all -> all);
    }

    private static double[] put(double[] numbers, int j, double value) {
        double[] changed = numbers.clone();
        changed[j] = value;
        return changed;
    }

    private static double[] reversed(double[] numbers) {
        return IntStream.range(0, numbers.length).mapToDouble(j -> numbers[numbers.length - 1 - j]).toArray();
    }

    /** @return the step of some entries, each with another one's derivative, while the others stand still */
    static Step part(Step step, IntPredicate moves, IntUnaryOperator rate) {
        return (source, deltaT) -> step.make(new Part(source, state(source), moves, rate), deltaT);
    }

    /** @return the steps of groups of entries, one after the other, or each from the start */
    static Stream<Step> inTurn(Step step, int groups, IntUnaryOperator group) {
        return Stream.of(false, true).map(fromStart -> (source, deltaT) -> {
            double t = source.getTime();
            double[] start = state(source);
            double[] end = start.clone();
            for (int g = 0; g < groups; g++) {
                int mine = g;
                source.incTime(t - source.getTime());
                part(step, k -> group.applyAsInt(k) == mine, k -> k).make(source, deltaT);
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

    static double[] state(DEStateSource source) {
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
     * @param rate   the entry of the derivative by which each moves
     */
    private record Part(DEStateSource source, double[] others, IntPredicate moves, IntUnaryOperator rate)
            implements DEStateSource {
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
            double[] whole = new double[dSdt.length];
            source.getStateDerivative(whole);
            Arrays.setAll(dSdt, k -> moves.test(k) ? whole[rate.applyAsInt(k)] : 0);
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
