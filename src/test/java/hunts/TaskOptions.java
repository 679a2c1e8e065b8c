package hunts;

import deSolvers.text.DidYouMean;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** Options of tasks that are not commands of the program, with the same rules and error messages. */
public final class TaskOptions {
    private final Map<String, String> given = new TreeMap<>();

    /**
     * @param args    {@code --name=value}, as the build hands {@code -Pname=value} on
     * @param allowed the known names
     * @throws IllegalArgumentException if a name is unknown or has no value; the message is for users
     */
    public TaskOptions(String[] args, List<String> allowed) {
        for (String arg : args) {
            String[] parts = arg.replaceFirst("^--", "").split("=", 2);
            if (!allowed.contains(parts[0])) {
                throw new IllegalArgumentException("unknown option -P" + parts[0]
                        + DidYouMean.hint(parts[0], allowed, "-P%s"::formatted)
                        + " allowed: -P" + String.join(", -P", allowed));
            }
            if (parts.length < 2) {
                throw new IllegalArgumentException("option -P" + parts[0] + " needs a value: -P" + parts[0] + "=...");
            }
            given.put(parts[0], parts[1]);
        }
    }

    /** @return an option's value, or the default */
    public String get(String name, String otherwise) {
        return given.getOrDefault(name, otherwise);
    }

    /**
     * @return the value of an option that is a whole number, 0 or more, or the default
     * @throws IllegalArgumentException if it is not such a number
     */
    public long getCount(String name, long otherwise) {
        String text = get(name, Long.toString(otherwise));
        if (!text.matches("\\d{1,18}")) {
            throw new IllegalArgumentException("-P" + name + " has to be a whole number, not '" + text + "'");
        }
        return Long.parseLong(text);
    }
}
