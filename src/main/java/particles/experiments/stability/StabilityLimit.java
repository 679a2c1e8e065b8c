package particles.experiments.stability;

import deSolvers.text.Digits;
import java.util.function.DoubleUnaryOperator;

/**
 * The stability limit in one direction of the complex plane.
 *
 * @param value  the largest h |lambda| up to which nothing grows; 0 if it always grows, infinite if it never does
 * @param growth the growth of the amplitude in a step at h |lambda| = {@value #SMALL}, as a fraction
 */
public record StabilityLimit(double value, double growth) {
    /** The h |lambda| at which growth is measured if every step grows. */
    static final double SMALL = 0.1;
    /** The least growth that counts, a few round-offs; that of bulirsch-stoer is 9e-14. */
    private static final double LEAST_GROWTH = 1e-14;
    /** A smaller growth shows that every step grows, but its digits are round-off. */
    static final double ROUND_OFF = 1e-12;
    /** A decay weaker than this may be round-off or Newton's tolerance. */
    private static final double DECAY = 1e-12;
    /**
     * The shortest step at which a decay is looked for: 1e-4 of |lambda| is the least damping that can be detected.
     */
    private static final double SHORTEST = 1e-5;
    private static final double LARGEST = 1e6;
    private static final double FACTOR = 1.02;
    private static final double ACCURACY = 1e-9;

    /**
     * Finds the limit: increases h |lambda| until something grows, and bisects the last interval to a relative accuracy
     * of 1e-9. Where a step of 0.1 already grows, shorter ones are tried, down to 1e-5, in which damping is stronger.
     *
     * @param amplification the amplification as a function of h |lambda|
     * @return the limit; beyond a million is unbounded
     */
    public static StabilityLimit measure(DoubleUnaryOperator amplification) {
        double growth = amplification.applyAsDouble(SMALL) - 1;
        double stable = SMALL;
        double unstable = SMALL;
        double most = growth > LEAST_GROWTH ? 1 : 1 + Amplification.ROUNDING;
        if (growth > LEAST_GROWTH) {
            while (amplification.applyAsDouble(stable) > 1 - DECAY) {
                unstable = stable;
                stable /= 2;
                if (stable < SHORTEST) {
                    return new StabilityLimit(0, growth);
                }
            }
        } else {
            while (amplification.applyAsDouble(unstable) <= most) {
                stable = unstable;
                unstable *= stable < 10 ? FACTOR : 2;
                if (unstable > LARGEST) {
                    return new StabilityLimit(Double.POSITIVE_INFINITY, growth);
                }
            }
        }
        while (unstable - stable > ACCURACY * stable) {
            double middle = (stable + unstable) / 2;
            if (amplification.applyAsDouble(middle) <= most) {
                stable = middle;
            } else {
                unstable = middle;
            }
        }
        return new StabilityLimit(stable, growth);
    }

    /** @return the text in a table; a dash if there is no number */
    String text() {
        return value != 0 || Double.isNaN(growth) ? brief()
                : growth < ROUND_OFF ? "no growth above 1e-12 per step"
                : Digits.format("always grows: %s per step", Digits.few(growth));
    }

    /** @return the text above a region, without the growth; a dash if that cannot be told from round-off */
    String brief() {
        if (Double.isNaN(value) || value == 0 && growth < ROUND_OFF) {
            return "-";
        }
        return value == 0 ? "always grows" : value == Double.POSITIVE_INFINITY ? "unbounded"
                : Digits.format("%.4f", value);
    }
}
