package particles.teaching.declared;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
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
    static Equation of(double[] states, double[] places, double... rates) {
        return new Equation(states, places, places, rates);
    }

    /** @return Adams and Bashforth's formula with these weights, the newest first */
    static Equation adams(double... rates) {
        return of(new double[] {1}, IntStream.range(0, rates.length).mapToDouble(j -> 0.0 - j).toArray(), rates);
    }

    /** @return whether it uses states or derivatives of earlier steps */
    public boolean usesEarlier() {
        return states.length > 1 || Arrays.stream(places).anyMatch(place -> place < 0);
    }

    /** @return whether the new state is in it */
    public boolean isImplicit() {
        return Arrays.stream(places).anyMatch(place -> place > 0);
    }

    /** @return the right side as a formula */
    public String formula() {
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
