package hunts;

import deSolvers.catalog.DidYouMean;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * The options of a task that is not a command of the program: the same rules, and the same words where they are broken.
 */
public final class TaskOptions {
    private final Map<String, String> given = new TreeMap<>();

    /**
     * @param args    {@code --name=value}, as the build hands {@code -Pname=value} on
     * @param allowed the names that there are
     * @throws IllegalArgumentException if another one is given, or one has no value; its message is for people to read
     */
    public TaskOptions(String[] args, List<String> allowed) {
        for (String arg : args) {
            String[] parts = arg.replaceFirst("^--", "").split("=", 2);
            if (!allowed.contains(parts[0])) {
                throw new IllegalArgumentException("unknown option -P" + parts[0] + (allowed.isEmpty()
                        ? "; this task has none"
                        : DidYouMean.hint(parts[0], allowed, "-P%s"::formatted)
                        + " allowed: -P" + String.join(", -P", allowed)));
            }
            if (parts.length < 2) {
                throw new IllegalArgumentException("option -P" + parts[0] + " needs a value: -P" + parts[0] + "=...");
            }
            given.put(parts[0], parts[1]);
        }
    }

    /** @return an option's value, or the given one where it was left out */
    public String get(String name, String otherwise) {
        return given.getOrDefault(name, otherwise);
    }

    /**
     * @return the value of an option that is a number of zero or more, or the given one where it was left out
     * @throws IllegalArgumentException if it is none
     */
    public long getCount(String name, long otherwise) {
        String text = get(name, Long.toString(otherwise));
        if (!text.matches("\\d{1,18}")) {
            throw new IllegalArgumentException("-P" + name + " has to be a whole number, not '" + text + "'");
        }
        return Long.parseLong(text);
    }
}
