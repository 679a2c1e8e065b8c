package particles.experiments.stability;

import java.util.Locale;
import java.util.function.DoubleUnaryOperator;

/**
 * How long a step may be in one direction of the complex plane.
 *
 * @param value  the largest h |lambda| from which 0 on nothing grows; 0 if it always grows, infinite if it never does
 * @param growth what a step at h |lambda| = {@value #SMALL} adds to the amplitude, as a part of it
 */
public record StabilityLimit(double value, double growth) {
    /** Where growth is measured that no shorter step ends. */
    static final double SMALL = 0.1;
    /** Growth there is known to a few roundings; bulirsch-stoer's is 9e-14, and still it grows. */
    private static final double LEAST_GROWTH = 1e-14;
    /** Smaller growth shows that there is no limit, but its digits are round-off. */
    private static final double ROUND_OFF = 1e-12;
    private static final double LARGEST = 1e6;
    private static final double FACTOR = 1.02;
    private static final double ACCURACY = 1e-9;

    /**
     * Goes outwards until something grows, and halves the last stretch until the place is known to 1e-9 of it.
     *
     * @param amplification of h |lambda|
     * @return the limit; beyond a million is unbounded
     */
    public static StabilityLimit measure(DoubleUnaryOperator amplification) {
        double growth = amplification.applyAsDouble(SMALL) - 1;
        if (growth > LEAST_GROWTH) {
            return new StabilityLimit(0, growth);
        }
        double stable = SMALL;
        double unstable = SMALL;
        while (isStable(amplification, unstable)) {
            stable = unstable;
            unstable *= stable < 10 ? FACTOR : 2;
            if (unstable > LARGEST) {
                return new StabilityLimit(Double.POSITIVE_INFINITY, growth);
            }
        }
        while (unstable - stable > ACCURACY * stable) {
            double middle = (stable + unstable) / 2;
            if (isStable(amplification, middle)) {
                stable = middle;
            } else {
                unstable = middle;
            }
        }
        return new StabilityLimit(stable, growth);
    }

    private static boolean isStable(DoubleUnaryOperator amplification, double h) {
        return amplification.applyAsDouble(h) <= 1 + Amplification.ROUNDING;
    }

    /** @return what a table says */
    String text() {
        return text(value, growth);
    }

    /**
     * @param value  a limit
     * @param growth a step at {@value #SMALL}, where the limit is 0
     * @return what a table says; a dash where there is no number
     */
    static String text(double value, double growth) {
        if (Double.isNaN(value)) {
            return "-";
        }
        if (value == 0) {
            return Double.isNaN(growth) ? "always grows"
                    : growth < ROUND_OFF ? "always grows: too little to see"
                    : String.format(Locale.ROOT, "always grows: %.2e a step", growth).replace("e-0", "e-");
        }
        return value == Double.POSITIVE_INFINITY ? "unbounded" : String.format(Locale.ROOT, "%.4f", value);
    }
}
