package particles.teaching.compared;

import deSolvers.DEStateSource;
import java.util.Arrays;
import java.util.function.BiFunction;
import java.util.function.IntFunction;
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

    /** @return the scheme with the rows 1 to to - 1 replaced */
    static Scheme rows(Scheme s, int to, BiFunction<Scheme, Integer, double[]> others) {
        Scheme changed = s;
        for (int r = 1; r < to; r++) {
            changed = changed.with(r, others.apply(changed, r));
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
        return plus(plus(s.rows()[r], s.rows()[0], -1), s.rows()[r - 1], 1);
    }

    /** @return the steps of groups of entries, one after the other, or each from the start */
    static Stream<Step> inTurn(Scheme scheme, IntUnaryOperator group) {
        return Stream.of(false, true).map(fromStart -> (source, deltaT) -> {
            double t = source.getTime();
            double[] start = state(source);
            double[] end = start;
            int groups = IntStream.range(0, end.length).map(group).max().orElse(0);
            for (int g = 0; g <= groups; g++) {
                int mine = g;
                double[] begin = fromStart ? start : end;
                source.setState(begin);
                source.incTime(t - source.getTime());
                scheme.make(source, deltaT, k -> group.applyAsInt(k) == mine);
                end = plus(end, plus(state(source), begin, -1), 1);
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
}
