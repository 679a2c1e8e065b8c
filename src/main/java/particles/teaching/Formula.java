package particles.teaching;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/** Formats coefficients and formulas as people write them: 1/6, deltaT/2, s + k1/2. */
public final class Formula {
    private static final double SAME = 1e-9;
    private static final int LARGEST_DENOMINATOR = 48;

    private Formula() {
    }

    /** @return whether two coefficients of order 1 are equal up to round-off */
    public static boolean same(double x, double y) {
        return Math.abs(x - y) <= SAME * Math.max(1, Math.abs(y));
    }

    /** @return the number as a fraction if it is a simple one, otherwise with four digits */
    public static String number(double x) {
        for (int q = 1; q <= LARGEST_DENOMINATOR; q++) {
            double p = Math.rint(x * q);
            if (Math.abs(p) < 1e6 && Math.abs(x * q - p) <= SAME * q * Math.max(1, Math.abs(x))) {
                return q == 1 ? Long.toString((long) p) : (long) p + "/" + q;
            }
        }
        return String.format(Locale.ROOT, "%.4g", x);
    }

    /** @return the text with these values in place of each %s, numbers with a fraction as people write them */
    public static String text(String format, Object... values) {
        return String.format(Locale.ROOT, format, Arrays.stream(values).map(value -> value instanceof Double x
                ? number(x) : value).toArray());
    }

    /** @return the time, such as {@code t + deltaT/2}; c is in units of deltaT */
    public static String time(double c) {
        return same(c, 0) ? "t" : "t" + (c < 0 ? " - " : " + ") + times(number(Math.abs(c)), "deltaT");
    }

    /**
     * @param weights the coefficients
     * @param names   the names that belong to the coefficients, as many or more; 1 for a number alone
     * @return the sum, such as {@code s + k1/2}
     */
    public static String sum(double[] weights, List<String> names) {
        StringBuilder text = new StringBuilder();
        for (int j = 0; j < weights.length; j++) {
            if (!same(weights[j], 0)) {
                text.append(text.length() == 0 ? weights[j] < 0 ? "-" : "" : weights[j] < 0 ? " - " : " + ").append(
                        times(number(Math.abs(weights[j])), names.get(j)));
            }
        }
        return text.length() == 0 ? "0" : text.toString();
    }

    private static String times(String size, String name) {
        return name.equals("1") ? size : size.equals("1") ? name : size.startsWith("1/") ? name + size.substring(1)
                : size + " " + name;
    }
}
