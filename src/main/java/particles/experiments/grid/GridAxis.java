package particles.experiments.grid;

import deSolvers.text.Digits;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import particles.spec.Setting;
import particles.view.Axis;

/**
 * An axis of a grid: a key of the scene and the values that it takes. It is written {@code KEY = VALUE, VALUE ...}, or
 * as a range: {@code KEY = 0 .. 40 by 5} in equal steps, {@code KEY = 1e-4 .. 1e-1 log 13} as 13 values in a
 * constant ratio. Several axes are separated by semicolons.
 *
 * @param key    the key, as {@link Setting} names it
 * @param values its values, as in a file
 * @param log    whether their ratio is constant, so that charts have a logarithmic axis
 * @param unit   the unit of its values; empty if they have none
 */
public record GridAxis(String key, List<String> values, boolean log, String unit) {
    /** The most axes: x, the curves and the panels of a chart. */
    public static final int MOST_AXES = 3;
    /** The most points of a grid. */
    public static final int MOST_POINTS = 1_000_000;
    private static final String NUMBER = "\\s*(\\S+)\\s*";
    private static final Pattern NUMERAL = Pattern.compile("[-+]?(\\d+\\.?\\d*|\\.\\d+)([eE][-+]?\\d+)?");
    private static final Pattern RANGE = Pattern.compile(NUMBER + "\\.\\." + NUMBER + "(?:\\s(by|log)" + NUMBER + ")?");
    private static final Pattern LIKE_RANGE = Pattern.compile("[^'\"\\[]*\\.\\.[^'\"]*");
    /** Values in a constant ratio have digits that can be read and typed; all others are as exact as sums are. */
    private static final int READABLE = 6;
    private static final int EXACT = 14;
    private static final double ROUNDING = 1e-12;

    /**
     * @param text axes as they were typed
     * @return one to three axes
     * @throws IllegalArgumentException if the text is none
     */
    public static List<GridAxis> list(String text) {
        List<GridAxis> axes = Setting.split(text, ';').stream().map(GridAxis::of).toList();
        if (axes.size() > MOST_AXES) {
            throw new IllegalArgumentException(axes.size() + " axes are too many; at most " + MOST_AXES);
        }
        if (axes.stream().map(GridAxis::key).distinct().count() < axes.size()) {
            throw new IllegalArgumentException("an axis appears twice");
        }
        double points = axes.stream().mapToDouble(axis -> axis.values.size()).reduce(1, (a, b) -> a * b);
        if (points > MOST_POINTS) {
            throw new IllegalArgumentException("that is " + Math.round(points) + " runs; at most " + MOST_POINTS);
        }
        return axes;
    }

    private static GridAxis of(String text) {
        int equals = text.indexOf('=');
        String key = equals < 0 ? "" : text.substring(0, equals).strip();
        String values = text.substring(equals + 1).strip();
        if (key.isEmpty() || values.isEmpty()) {
            throw new IllegalArgumentException("'" + text.strip() + "' has to be KEY = VALUE, VALUE ... or"
                    + " KEY = FIRST .. LAST by STEP");
        }
        if (LIKE_RANGE.matcher(values).matches()) {
            return range(key, values);
        }
        List<String> list = Setting.split(values, ',').stream().map(String::strip).toList();
        if (list.contains("")) {
            throw new IllegalArgumentException("a value of '" + key + "' is empty");
        }
        if (new LinkedHashSet<>(list).size() < list.size()) {
            throw new IllegalArgumentException("a value of '" + key + "' appears twice");
        }
        return new GridAxis(key, list, false, "");
    }

    private static GridAxis range(String key, String values) {
        Matcher range = RANGE.matcher(values);
        if (!range.matches() || range.group(3) == null) {
            throw new IllegalArgumentException("'" + values + "' is not a range such as 0 .. 40 by 5 or"
                    + " 1e-4 .. 1e-1 log 13");
        }
        double first = number(range.group(1));
        double last = number(range.group(2));
        double by = number(range.group(4));
        boolean log = range.group(3).equals("log");
        if (log && !(first > 0 && last > 0 && first != last)) {
            throw new IllegalArgumentException("a logarithmic range needs two different ends over 0, not"
                    + " '" + values + "'");
        }
        if (log && !(by >= 2 && by == Math.rint(by))) {
            throw new IllegalArgumentException("in '" + values + "', log has to be followed by the number of"
                    + " values, 2 or more");
        }
        double steps = log ? by - 1 : Math.floor((last - first) / by * (1 + ROUNDING));
        if (!(steps >= 0 && Double.isFinite(steps))) {
            throw new IllegalArgumentException("in '" + values + "' the step does not lead to the last value");
        }
        if (steps >= MOST_POINTS) {
            throw new IllegalArgumentException("'" + values + "' has too many values; at most " + MOST_POINTS);
        }
        double ratio = StrictMath.log(last / first);
        List<String> list = IntStream.rangeClosed(0, (int) steps).mapToObj(k -> k == 0 ? Digits.few(first, EXACT)
                : !log ? Digits.few(first + k * by, EXACT) : k == steps ? Digits.few(last, EXACT)
                : Digits.few(first * StrictMath.exp(ratio * k / steps), READABLE)).toList();
        if (new LinkedHashSet<>(list).size() < list.size()) {
            throw new IllegalArgumentException("'" + values + "' has too many values: with the digits shown,"
                    + " some are equal");
        }
        return new GridAxis(key, list, log, "");
    }

    private static double number(String text) {
        if (!NUMERAL.matcher(text).matches()) {
            throw new IllegalArgumentException("'" + text + "' is not a number");
        }
        double number = Double.parseDouble(text);
        if (Double.isInfinite(number)) {
            throw new IllegalArgumentException("'" + text + "' is too large");
        }
        return number;
    }

    /** @return the axis with values in this unit */
    public GridAxis in(String unit) {
        return new GridAxis(key, values, log, unit);
    }

    /** @return whether its values are numbers */
    boolean isNumeric() {
        try {
            values.forEach(Double::parseDouble);
            return true;
        } catch (NumberFormatException e) {
            return false;
        }
    }

    /** @return the axis of a chart */
    Axis axis() {
        return new Axis(key, unit, log);
    }
}
