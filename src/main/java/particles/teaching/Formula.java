package particles.teaching;

import java.util.List;
import java.util.Locale;

/** Writes coefficients as people do: 1/6, deltaT/2, s + k1/2. */
public final class Formula {
    private static final double SAME = 1e-9;
    private static final int LARGEST_DENOMINATOR = 48;

    private Formula() {
    }

    /** @return whether two coefficients of order 1 are the same but for rounding */
    public static boolean same(double x, double y) {
        return Math.abs(x - y) <= SAME * Math.max(1, Math.abs(y));
    }

    /** @return the number as a fraction where it is a simple one, else with four digits */
    public static String number(double x) {
        for (int q = 1; q <= LARGEST_DENOMINATOR; q++) {
            double p = Math.rint(x * q);
            if (Math.abs(p) < 1e6 && Math.abs(x * q - p) <= SAME * q * Math.max(1, Math.abs(x))) {
                return q == 1 ? Long.toString((long) p) : (long) p + "/" + q;
            }
        }
        return String.format(Locale.ROOT, "%.4g", x);
    }

    /** @return such as {@code t + deltaT/2}; c is in units of deltaT */
    public static String time(double c) {
        return same(c, 0) ? "t" : "t" + term(c, "deltaT");
    }

    /**
     * @param kept   how much of s is in it
     * @param weight the coefficients
     * @param names  of what they belong to
     * @return such as {@code s + k1/2}
     */
    public static String state(double kept, double[] weight, List<String> names) {
        StringBuilder text = new StringBuilder(same(kept, 1) ? "s" : same(kept, 0) ? "" : number(kept) + " s");
        for (int j = 0; j < weight.length; j++) {
            if (!same(weight[j], 0)) {
                text.append(term(weight[j], j < names.size() ? names.get(j) : "k" + (j + 1)));
            }
        }
        return text.isEmpty() ? "0" : text.toString().replaceFirst("^ \\+ ", "");
    }

    private static String term(double coefficient, String name) {
        String sign = coefficient < 0 ? " - " : " + ";
        double size = Math.abs(coefficient);
        if (same(size, 1)) {
            return sign + name;
        }
        String number = number(size);
        return sign + (number.startsWith("1/") ? name + number.substring(1) : number + " " + name);
    }
}
