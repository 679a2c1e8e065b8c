package particles.lab.browser;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Java's {@code %g}, which the page's {@code String.format} does not know: plain or with an exponent. */
final class GeneralFormat {
    private static final Pattern SPECIFIER = Pattern.compile("%([^a-zA-Z%]*)([a-zA-Z%])");
    private static final int DIGITS = 6;

    private final StringBuffer format = new StringBuffer();
    private final Object[] arguments;

    /**
     * @param format    with {@code %g} or without
     * @param arguments of it, one for each specifier
     */
    GeneralFormat(String format, Object[] arguments) {
        this.arguments = arguments.clone();
        Matcher matcher = SPECIFIER.matcher(format);
        int next = 0;
        while (matcher.find()) {
            String letter = matcher.group(2);
            if (letter.equals("g")) {
                String precision = matcher.group(1).replace(".", "");
                this.arguments[next] = general((Double) arguments[next],
                        precision.isEmpty() ? DIGITS : Integer.parseInt(precision));
                matcher.appendReplacement(this.format, "%s");
            }
            next += letter.equals("%") || letter.equals("n") ? 0 : 1;
        }
        matcher.appendTail(this.format);
    }

    /** The same format with {@code %s} in the place of {@code %g}. */
    String format() {
        return format.toString();
    }

    /** Its arguments: texts in the place of the numbers. */
    Object[] arguments() {
        return arguments;
    }

    private static String general(double value, int digits) {
        if (!Double.isFinite(value)) {
            return Double.toString(value);
        }
        MathContext context = new MathContext(digits, RoundingMode.HALF_UP);
        BigDecimal rounded = new BigDecimal(Double.toString(value)).round(context);
        int exponent = rounded.signum() == 0 ? 0 : rounded.precision() - rounded.scale() - 1;
        if (exponent >= -4 && exponent < digits) {
            return rounded.setScale(digits - 1 - exponent, RoundingMode.HALF_UP).toPlainString();
        }
        String mantissa = rounded.movePointLeft(exponent).setScale(digits - 1, RoundingMode.HALF_UP).toPlainString();
        return mantissa + (exponent < 0 ? "e-" : "e+") + (Math.abs(exponent) < 10 ? "0" : "") + Math.abs(exponent);
    }
}
