package particles.teaching.solvers;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.teaching.Formula;

/**
 * The equation that a step of an implicit or a multistep method fulfils: new = a1 s + a2 s(1 step before) + ...
 * + deltaT (b1 f1 + b2 f2 + ...).
 *
 * @param states the weights of s and of the states before it
 * @param places where each derivative is: 0 at s, 1 at the new state, 1/2 half way between, -1 at the state before s
 * @param clocks when it is, in units of deltaT since the step began
 * @param rates  the weights of the derivatives
 */
public record Equation(double[] states, double[] places, double[] clocks, double[] rates) {
    /** The place of the state before the first of six steps. */
    private static final double FIRST = -5;

    static Equation of(double[] states, double[] places, double... rates) {
        return new Equation(states, places, places, rates);
    }

    /** @return Adams and Bashforth's formula with these weights, the newest first */
    static Equation adams(double... rates) {
        return of(new double[] {1}, IntStream.range(0, rates.length).mapToDouble(j -> 0.0 - j).toArray(), rates);
    }

    /** @return whether it uses states or derivatives of earlier steps */
    boolean usesEarlier() {
        return states.length > 1 || Arrays.stream(places).anyMatch(place -> place < 0);
    }

    /** @return whether the new state is in it */
    boolean isImplicit() {
        return Arrays.stream(places).anyMatch(place -> place > 0);
    }

    /** @return the typical mistakes in it */
    Stream<Equation> changed() {
        Stream<double[]> clock = isImplicit() ? IntStream.range(0, clocks.length).boxed().flatMap(j -> Stream.of(0.0,
                0.5, 1.0).map(t -> put(clocks, j, t))) : Stream.empty();
        Stream<double[]> rate = Stream.concat(Stream.of(-1.0, 0.5, 2.0, 1 / Scheme.sum(rates)).map(factor ->
                Changes.scaled(rates, 0, 99, factor)), IntStream.range(0, rates.length).boxed().flatMap(j -> Stream.of(
                -1.0, 0.0, 0.5, 2.0, 1 / rates[j]).map(factor -> Changes.scaled(rates, j, j + 1, factor))));
        Stream<double[]> state = IntStream.range(0, states.length).mapToObj(j -> Changes.scaled(states, j, j + 1, -1));
        Stream<double[]> place = usesEarlier() ? IntStream.range(0, places.length).boxed().flatMap(j ->
                Stream.of(places[j]
                - 1, places[j] + 1, isImplicit() ? places[j] : FIRST).map(other -> put(places, j, other)))
                        : Stream.empty();
        return Stream.of(clock.map(c -> new Equation(states, places, c, rates)), rate.map(w -> new Equation(states,
                places, clocks, w)), Stream.of(new Equation(states, places, clocks, reversed(rates)), new Equation(
                reversed(states), places, clocks, rates)), state.map(a -> new Equation(a, places, clocks, rates)),
                place.map(p -> new Equation(states, p, p, rates)), Stream.of(new Equation(states,
                        new double[places.length], clocks, rates)).filter(one -> !isImplicit())).flatMap(all -> all);
    }

    private static double[] put(double[] numbers, int j, double value) {
        double[] changed = numbers.clone();
        changed[j] = value;
        return changed;
    }

    private static double[] reversed(double[] numbers) {
        return IntStream.range(0, numbers.length).mapToDouble(j -> numbers[numbers.length - 1 - j]).toArray();
    }

    /** @return the right side as a formula */
    String formula() {
        List<String> names = new ArrayList<>();
        IntStream.range(0, states.length).forEach(j -> names.add(state(-j)));
        IntStream.range(0, rates.length).forEach(j -> names.add("deltaT f(" + state(places[j]) + ", " + Formula.time(
                clocks[j]) + ")"));
        return Formula.sum(join(states, rates), names);
    }

    static double[] join(double[] one, double[] two) {
        double[] both = Arrays.copyOf(one, one.length + two.length);
        System.arraycopy(two, 0, both, one.length, two.length);
        return both;
    }

    private static String state(double place) {
        return place == 0 ? "s" : place == 1 ? "new" : place > 0 ? "(s + new)/2" : "s at " + Formula.time(place);
    }
}
