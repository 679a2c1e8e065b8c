package particles.spec;

import deSolvers.text.Digits;
import java.util.Optional;
import java.util.regex.Pattern;
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
}
