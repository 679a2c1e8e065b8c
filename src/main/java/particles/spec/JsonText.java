package particles.spec;

import deSolvers.text.Digits;
import java.util.Arrays;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Writes JSON. NaN and infinity are written as {@code null}, since JSON cannot express them. */
public final class JsonText {
    /** The last character that JSON which is read as YAML may contain as it is. */
    private static final char LAST = '\ufffd';

    private JsonText() {
    }

    /**
     * Indented, and with numbers as people write them.
     *
     * @param value maps with texts as keys, lists, numbers, booleans and texts
     * @return the text, ending with a line feed
     */
    public static String of(Object value) {
        return write(value, "\n") + "\n";
    }

    /**
     * In one line, for programs.
     *
     * @param value as for {@link #of}, and arrays of whole numbers
     */
    public static String compact(Object value) {
        return write(value, "");
    }

    /**
     * @param keysAndValues keys and values in turn
     * @return a map that keeps their order and can be changed
     */
    public static Map<String, Object> map(Object... keysAndValues) {
        Map<String, Object> map = new LinkedHashMap<>();
        for (int k = 0; k < keysAndValues.length; k += 2) {
            map.put((String) keysAndValues[k], keysAndValues[k + 1]);
        }
        return map;
    }

    /** @param line begins a line of what is around the value; empty without lines */
    private static String write(Object value, String line) {
        String inner = line.isEmpty() ? "" : line + "  ";
        if (value instanceof Map<?, ?> map) {
            return enclosed("{", map.entrySet().stream().map(entry -> quote(entry.getKey().toString())
                    + (line.isEmpty() ? ":" : " : ") + write(entry.getValue(), inner)), "}", line, inner);
        }
        if (value instanceof Collection<?> list) {
            return enclosed("[", list.stream().map(element -> write(element, inner)), "]", line, inner);
        }
        if (value instanceof int[] numbers) {
            return Arrays.toString(numbers);
        }
        if (value instanceof Double number && (!line.isEmpty() || !Double.isFinite(number))) {
            return Double.isFinite(number) ? Digits.exact(number) : "null";
        }
        return value instanceof Number || value instanceof Boolean ? value.toString() : quote(value.toString());
    }

    private static String enclosed(String open, Stream<String> parts, String close, String line, String inner) {
        String all = parts.collect(Collectors.joining("," + inner));
        return open + (all.isEmpty() ? line.isEmpty() ? "" : " " : inner + all + line) + close;
    }

    private static String quote(String text) {
        StringBuilder quoted = new StringBuilder("\"");
        for (char c : text.toCharArray()) {
            quoted.append(c == '"' || c == '\\' ? "\\" + c : Character.isISOControl(c) || c > LAST
                    ? String.format("\\u%04x", (int) c) : "" + c);
        }
        return quoted.append('"').toString();
    }
}
