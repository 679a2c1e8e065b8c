package particles.teaching.declared;

import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * The equation that a step of an implicit or a multistep method fulfils: new = a1 s + a2 s(1 step before) + ...
 * + deltaT (b1 f1 + b2 f2 + ...).
 *
 * @param states the weights of s and of the states before it
 * @param places where each derivative is: 0 at s, 1 at the new state, 1/2 half way between, -1 at the state before s;
 *               the clock is as many deltaT after that of s
 * @param rates  the weights of the derivatives
 */
public record Equation(double[] states, double[] places, double... rates) {
    /** @return Adams and Bashforth's formula with these weights, the newest first */
    static Equation adams(double... rates) {
        return new Equation(new double[] {1}, IntStream.range(0, rates.length).mapToDouble(j -> 0.0 - j).toArray(),
                rates);
    }

    /** @return whether it uses states or derivatives of earlier steps */
    public boolean usesEarlier() {
        return states.length > 1 || Arrays.stream(places).anyMatch(place -> place < 0);
    }

    /** @return whether the new state is in it */
    public boolean isImplicit() {
        return Arrays.stream(places).anyMatch(place -> place > 0);
    }
}
