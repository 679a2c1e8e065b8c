package particles.spec;

import deSolvers.text.Digits;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.snakeyaml.engine.v2.common.ScalarStyle;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.ScalarNode;

/**
 * Recognises common mistakes in typed numbers, such as {@code 0,01} and {@code 10 ms}, and suggests the right form.
 */
final class NumberMistake {
    private static final String NUMBER = "[-+]?(?:\\d+\\.?\\d*|\\.\\d+)(?:[eE][-+]?\\d+)?";
    private static final Pattern PLAIN = Pattern.compile(NUMBER);
    private static final Pattern COMMA = Pattern.compile("([-+]?\\d*),(\\d+(?:[eE][-+]?\\d+)?)");
    private static final Pattern FRACTION = Pattern.compile("(" + NUMBER + ")\\s*/\\s*(" + NUMBER + ")");
    private static final Pattern POWER = Pattern.compile(
            "(?:([-+]?\\d+\\.?\\d*)\\s*[*x\u00d7\u00b7]\\s*)?10\\s*(?:\\^|\\*\\*)\\s*\\(?([-+]?\\d+)\\)?");
    private static final Pattern WITH_UNIT = Pattern.compile("(" + NUMBER + ")\\s*([\\p{L}\u00b5%\u00b0][^,]{0,20})");
    private static final Pattern HEXADECIMAL = Pattern.compile("[-+]?0[xX][0-9a-fA-F.]+([pP][-+]?\\d+)?");
    /** Characters that look like those of a number: dashes such as the mathematical minus, full-width ones, spaces. */
    private static final String LOOKALIKES = "\u2212\u2013\u2011\uff0d\uff0b\uff0e\uff0c\u00a0\u202f\u2007\u3000";
    private static final String MEANT = "----+.,    ";
    /** Conversion factors from the first unit to the second, which is that of the key. */
    private static final Map<String, Double> FACTORS = Map.ofEntries(Map.entry("ms s", 1e-3), Map.entry("us s", 1e-6),
            Map.entry("\u00b5s s", 1e-6), Map.entry("min s", 60.0), Map.entry("mm m", 1e-3), Map.entry("cm m", 1e-2),
            Map.entry("km m", 1e3), Map.entry("g kg", 1e-3), Map.entry("mg kg", 1e-6), Map.entry("t kg", 1e3));

    private NumberMistake() {
    }

    /**
     * @param node the value found in place of a number
     * @param unit the unit of that number, or empty
     * @return the mistake and its remedy, as text to follow a semicolon; empty if it is no known mistake
     */
    static Optional<String> of(Node node, String unit) {
        if (!(node instanceof ScalarNode scalar)) {
            return Optional.empty();
        }
        String text = ordinary(scalar.getValue()).strip();
        boolean quoted = scalar.getScalarStyle() != ScalarStyle.PLAIN;
        return found(PLAIN, text, number -> (quoted ? "a number has no quotes"
                : "a character of it only looks like an ordinary digit, sign or space") + "; write " + text)
                .or(() -> found(HEXADECIMAL, text, number -> "a hexadecimal number has no sign, point or exponent;"
                        + " write it in decimal digits"))
                .or(() -> found(COMMA, text, number -> "a number has a decimal point, not a comma; write "
                        + number.group(1) + "." + number.group(2)))
                .or(() -> found(FRACTION, text, fraction -> result(Double.parseDouble(fraction.group(1))
                        / Double.parseDouble(fraction.group(2)))))
                .or(() -> found(POWER, text, power -> result(Double.parseDouble(
                        (power.group(1) == null ? "1" : power.group(1)) + "e" + power.group(2)))))
                .or(() -> found(WITH_UNIT, text, number -> withUnit(number, unit)));
    }

    /** The remedy if the whole text is such a mistake; none if it is null. */
    private static Optional<String> found(Pattern mistake, String text, Function<MatchResult, String> remedy) {
        Matcher match = mistake.matcher(text);
        return match.matches() ? Optional.ofNullable(remedy.apply(match)) : Optional.empty();
    }

    /** The text with ordinary characters in place of those that look like them. */
    private static String ordinary(String text) {
        StringBuilder ordinary = new StringBuilder();
        text.codePoints().forEach(c -> {
            int index = LOOKALIKES.indexOf(c);
            ordinary.appendCodePoint(index >= 0 ? MEANT.charAt(index)
                    : Character.isDigit(c) ? '0' + Character.digit(c, 10) : c);
        });
        return ordinary.toString();
    }

    private static String result(double value) {
        return Double.isFinite(value) ? "expressions are not calculated; write " + Digits.exact(value) : null;
    }

    private static String withUnit(MatchResult number, String unit) {
        String found = number.group(2).strip();
        Double factor = found.equals(unit) ? Double.valueOf(1) : FACTORS.get(found + " " + unit);
        if (factor == null) {
            return "write the number without a unit" + (unit.isEmpty() ? "" : "; here it is in " + unit);
        }
        double value = Double.parseDouble(number.group(1)) * factor;
        double rounded = new BigDecimal(value).round(new MathContext(15)).doubleValue();
        return "write the number without its unit: " + Digits.exact(rounded);
    }
}
