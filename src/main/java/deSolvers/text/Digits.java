package deSolvers.text;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.Locale;

/** Numbers in messages for people: a few digits, the same in every locale. */
public final class Digits {
    private static final int FEW = 3;

    private Digits() {
    }

    /** @return the number with 3 digits at most: 0.05, 12.6, 6.02e23 */
    public static String few(double value) {
        return write(value, new MathContext(FEW, RoundingMode.HALF_EVEN));
    }

    /** @return the number with so many digits at most */
    public static String few(double value, int digits) {
        return write(value, new MathContext(digits));
    }

    /** @return the text with numbers in it, the same in every locale; see {@link String#format} */
    public static String format(String text, Object... values) {
        return String.format(Locale.ROOT, text, values);
    }

    /** @return the number rounded towards zero to so many digits, for numbers that have to stay below a limit */
    public static String roundedDown(double value, int digits) {
        return write(value, new MathContext(digits, RoundingMode.DOWN));
    }

    /** @return the number with all its digits, as people write it: 0.001, 12.566370614359172, 20 */
    public static String exact(double value) {
        return write(value, MathContext.UNLIMITED);
    }

    /** As {@link #exact(double)}. */
    public static String exact(BigDecimal value) {
        BigDecimal digits = value.stripTrailingZeros();
        int exponent = digits.precision() - digits.scale() - 1;
        return digits.signum() == 0 || exponent >= -4 && exponent < 7 ? digits.toPlainString()
                : digits.scaleByPowerOfTen(-exponent).toPlainString() + "e" + exponent;
    }

    /** @return the smallest of 1, 2 and 5 times a power of ten that is at least a positive number, up to round-off */
    public static BigDecimal roundStep(double least) {
        double wanted = Math.max(least, Double.MIN_NORMAL) * (1 - 1e-9);
        BigDecimal power = BigDecimal.ONE.scaleByPowerOfTen(
                BigDecimal.valueOf(Math.log10(wanted)).setScale(0, RoundingMode.FLOOR).intValue());
        for (int factor : new int[] {1, 2, 5}) {
            BigDecimal step = power.multiply(BigDecimal.valueOf(factor));
            if (step.doubleValue() >= wanted) {
                return step;
            }
        }
        return power.scaleByPowerOfTen(1);
    }

    private static String write(double value, MathContext digits) {
        if (!Double.isFinite(value)) {
            return Double.isNaN(value) ? "not a number" : value > 0 ? "over 1e308" : "below -1e308";
        }
        return exact(BigDecimal.valueOf(value).round(digits));
    }
}
