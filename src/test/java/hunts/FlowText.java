package hunts;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Pattern;

/** Writes trees of maps, lists, texts and numbers as YAML in one line; quicker than a general writer. */
final class FlowText {
    private static final Pattern PLAIN = Pattern.compile("[A-Za-z][A-Za-z0-9_.-]*");
    private static final Set<String> NO_TEXT =
            Set.of("true", "false", "null", "True", "False", "Null", "TRUE", "FALSE", "NULL");

    private FlowText() {
    }

    static void append(Object value, StringBuilder to) {
        if (value instanceof Map<?, ?> map) {
            String before = "{";
            for (Map.Entry<?, ?> entry : map.entrySet()) {
                to.append(before);
                append(entry.getKey(), to);
                to.append(": ");
                append(entry.getValue(), to);
                before = ", ";
            }
            to.append(map.isEmpty() ? "{}" : "}");
        } else if (value instanceof List<?> list) {
            String before = "[";
            for (Object child : list) {
                to.append(before);
                append(child, to);
                before = ", ";
            }
            to.append(list.isEmpty() ? "[]" : "]");
        } else if (value instanceof Double number) {
            to.append(number.isNaN() ? ".nan" : number.isInfinite() ? number > 0 ? ".inf" : "-.inf"
                    : number.toString());
        } else if (value instanceof String text) {
            appendText(text, to);
        } else {
            to.append(value);                               // a whole number, true, false or null
        }
    }

    private static void appendText(String text, StringBuilder to) {
        if (PLAIN.matcher(text).matches() && !NO_TEXT.contains(text)) {
            to.append(text);
            return;
        }
        to.append('"');
        for (int k = 0; k < text.length(); k++) {
            char c = text.charAt(k);
            if (c == '"' || c == '\\') {
                to.append('\\').append(c);
            } else if (c < ' ' || c >= 0x7f) {
                to.append(String.format("\\u%04x", (int) c));
            } else {
                to.append(c);
            }
        }
        to.append('"');
    }
}
