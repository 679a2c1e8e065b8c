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
import org.snakeyaml.engine.v2.nodes.Tag;

/**
 * The type of a finite number in a range.
 *
 * @param least the smallest number allowed
 * @param most  the largest number allowed
 * @param unit  its unit; empty for pure numbers
 * @param range the numbers allowed, in words
 */
public record NumberType(double least, double most, String unit, String range) implements Type<Double> {
    /** The largest number allowed in a scene; products of a few such numbers are still finite. */
    private static final double HUGE = 1e30;
    /** The smallest positive number allowed, far below an electron's mass in kg; its inverse is finite. */
    public static final double TINY = 1e-40;
    /** A number over 0, however small; Java reads 1e-400 as 0. */
    private static final Pattern OVER_ZERO = Pattern.compile("[+]?[0.]*[1-9].*");

    /** @return the type of numbers over 0; the unit is empty for pure numbers */
    public static NumberType positive(String unit) {
        return new NumberType(TINY, HUGE, unit, "a number over 0");
    }

    /** @return the type of numbers of 0 or more */
    public static NumberType notNegative(String unit) {
        return new NumberType(0, HUGE, unit, "a number from 0 up");
    }

    /** @return the type of any numbers */
    public static NumberType any(String unit) {
        return new NumberType(-HUGE, HUGE, unit, "a number");
    }

    /** @return the type of numbers from least to most, both included */
    public static NumberType between(double least, double most, String unit) {
        return new NumberType(least, most, unit,
                "a number from " + Digits.exact(least) + " to " + Digits.exact(most));
    }

    @Override
    public Optional<Double> read(Node node, String what, Reading in) {
        Optional<Double> number = parse(node);
        if (number.isEmpty()) {
            Optional<String> mistake = NumberMistake.of(node, unit);
            return wrong(node, what, mistake.orElse("it has to be " + describe()), in);
        }
        double value = number.get();
        if (value >= 0 && value < TINY && OVER_ZERO.matcher(((ScalarNode) node).getValue()).matches()) {
            return wrong(node, what, "positive numbers in a scene are at least " + Digits.exact(TINY), in);
        }
        if (value <= most && value >= least) {
            in.numbers().add(new Reading.NumberInText(what, value, in.place(node), least, most, unit));
            return number;
        }
        if (Double.isNaN(value) && !((ScalarNode) node).getValue().equalsIgnoreCase(".nan") || Math.abs(value) > HUGE) {
            return wrong(node, what, "numbers in a scene are at most 1e30", in);
        }
        return wrong(node, what, in);
    }

    /** Parses a number by YAML 1.2's core schema: 1e-3, .5, +2, 0x10, but also .inf and .nan. */
    static Optional<Double> parse(Node node) {
        if (!(node instanceof ScalarNode) || !(node.getTag().equals(Tag.INT) || node.getTag().equals(Tag.FLOAT))) {
            return Optional.empty();
        }
        String text = ((ScalarNode) node).getValue();
        try {
            if (text.startsWith("0x") || text.startsWith("0o")) {
                return Optional.of((double) Long.parseLong(text.substring(2), text.startsWith("0x") ? 16 : 8));
            }
            return Optional.of(Double.parseDouble(text));
        } catch (NumberFormatException e) {
            return Optional.of(Double.NaN);             // .inf, .nan or a huge hexadecimal number: not in any range
        }
    }

    @Override
    public Optional<Double> sample() {
        return Optional.of(least <= 2 && 2 <= most ? 2 : (least + most) / 2);
    }

    @Override
    public String describe() {
        return range + inUnit();
    }

    /** @return the unit, to follow a description */
    String inUnit() {
        return unit.isEmpty() ? "" : " (" + unit + ")";
    }

    /**
     * Recognises common mistakes in typed numbers, such as {@code 0,01} and {@code 10 ms}, and suggests the right form.
     */
    private static final class NumberMistake {
        private static final String NUMBER = "[-+]?(?:\\d+\\.?\\d*|\\.\\d+)(?:[eE][-+]?\\d+)?";
        private static final Pattern PLAIN = Pattern.compile(NUMBER);
        private static final Pattern COMMA = Pattern.compile("([-+]?\\d*),(\\d+(?:[eE][-+]?\\d+)?)");
        private static final Pattern FRACTION = Pattern.compile("(" + NUMBER + ")\\s*/\\s*(" + NUMBER + ")");
        private static final Pattern POWER = Pattern.compile(
                "(?:([-+]?\\d+\\.?\\d*)\\s*[*x\u00d7\u00b7]\\s*)?10\\s*(?:\\^|\\*\\*)\\s*\\(?([-+]?\\d+)\\)?");
        private static final Pattern WITH_UNIT = Pattern.compile(
                "(" + NUMBER + ")\\s*([\\p{L}\u00b5%\u00b0][^,]{0,20})");
        private static final Pattern HEXADECIMAL = Pattern.compile("[-+]?0[xX][0-9a-fA-F.]+([pP][-+]?\\d+)?");
        /**
         * Characters that look like those of a number: dashes such as the mathematical minus, full-width ones, spaces.
         */
        private static final String LOOKALIKES = "\u2212\u2013\u2011\uff0d\uff0b\uff0e\uff0c\u00a0\u202f\u2007\u3000";
        private static final String MEANT = "----+.,    ";
        /** Conversion factors from the first unit to the second, which is that of the key. */
        private static final Map<String, Double> FACTORS = Map.of("ms s", 1e-3, "us s", 1e-6, "\u00b5s s", 1e-6,
                "min s", 60.0, "mm m", 1e-3, "cm m", 1e-2, "km m", 1e3, "g kg", 1e-3, "mg kg", 1e-6, "t kg", 1e3);

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

    /**
     * The type of a whole number in a range; 20.0 and 2e1 count as 20.
     *
     * @param least the smallest number allowed
     * @param most  the largest number allowed
     */
    public record Whole(int least, int most) implements Type<Integer> {
        @Override
        public Optional<Integer> read(Node node, String what, Reading in) {
            return NumberType.parse(node).filter(number -> number == StrictMath.rint(number) && number >= least
                    && number <= most).map(Double::intValue).or(() -> wrong(node, what, in));
        }

        @Override
        public Optional<Integer> sample() {
            return Optional.of(Math.max(least, Math.min(2, most)));
        }

        @Override
        public String describe() {
            return "a whole number from " + least + " to " + most;
        }
    }
}
