package particles.teaching.exercises;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import particles.spec.messages.InvalidInputException;

/** A number as a student types it: with a decimal point or comma, as a fraction, with or without its unit. */
final class AnswerText {
    private static final int LONGEST = 60;
    private static final String NUMBER = "[+-]?(?:\\d+[.,]?\\d*|[.,]\\d+)(?:\\s*[eE][+-]?\\d+)?";
    /** The text before a number: x = or an equals sign alone. */
    private static final String NAME = "^(?:[A-Za-z]\\w*\\s*)?[=\u2248~]\\s*";
    /** Other ways to write a unit, without spaces and signs of multiplication. */
    private static final Map<String, List<String>> SAME_UNITS = Map.of("Ns/m", List.of("kg/s"), "m/s", List.of("ms^-1",
            "ms-1"));
    private static final Pattern FORM = Pattern.compile("(" + NUMBER + ")(?:\\s*/\\s*(" + NUMBER + "))?\\s*(.*)");

    private AnswerText() {
    }

    /**
     * @param typed the text as typed
     * @param unit  the unit in which the number is wanted; empty for a pure number
     * @return the number
     * @throws InvalidInputException with the mistake in one line, if it is none
     */
    static double read(String typed, String unit) {
        String text = typed.strip().replaceFirst(NAME, "").replace('\u2212',
                '-').replaceAll("\\s*[x*\u00d7\u00b7]\\s*10\\s*\\^\\s*", "e");
        if (text.isEmpty()) {
            throw noNumber("The answer is empty");
        }
        String shown = text.length() > LONGEST ? text.substring(0, LONGEST) + "..." : text;
        if (text.toLowerCase(Locale.ROOT).matches("[+-]?(nan|inf|infinity|\u221e).*")) {
            throw noNumber("'" + shown + "' is no finite number: a calculation has divided by 0 or blown up");
        }
        if (text.matches("[+-]?[\\d ']*\\d[.,]\\d+[.,]\\d+.*")) {
            throw noNumber("'" + shown + "' has two points or commas; write no separators of thousands");
        }
        Matcher matcher = FORM.matcher(text);
        if (!matcher.matches()) {
            throw noNumber("'" + shown + "' is not a number");
        }
        double value = number(matcher.group(1));
        if (matcher.group(2) != null) {                 // null where there is no fraction
            value /= number(matcher.group(2));
        }
        if (!Double.isFinite(value)) {
            throw noNumber("'" + shown + "' is no finite number");
        }
        String rest = packed(matcher.group(3));
        if (unit.isEmpty() && rest.equals("%")) {
            return value / 100;
        }
        if (!rest.isEmpty() && !rest.equals(packed(unit)) && !SAME_UNITS.getOrDefault(packed(unit), List.of())
                .contains(rest)) {
            throw new InvalidInputException("'" + matcher.group(3).strip() + "' after the number is not"
                    + " understood: the answer is wanted "
                    + (unit.isEmpty() ? "as a pure number" : "in " + unit) + ", with or without the unit.");
        }
        return value;
    }

    private static String packed(String unit) {
        return unit.replaceAll("[\\s*\u00b7]", "");
    }

    private static double number(String text) {
        return Double.parseDouble(text.replace(',', '.').replaceAll("\\s", ""));
    }

    private static InvalidInputException noNumber(String problem) {
        return new InvalidInputException(problem + "; a number is wanted, such as 0.1234, 0,1234, 1.234e-3 or 3/8.");
    }
}
