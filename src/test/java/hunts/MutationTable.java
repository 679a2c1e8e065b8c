package hunts;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;

/** Counts the mutants killed in each class, from PIT's {@code mutations.csv}. */
final class MutationTable {
    /** The number of mutants, of killed ones, and of those killed by a timeout. */
    record Count(int mutants, int killed, int timedOut) {
        static final Count NONE = new Count(0, 0, 0);

        Count plus(Count other) {
            return new Count(mutants + other.mutants, killed + other.killed, timedOut + other.timedOut);
        }

        /** The percentage killed; 100 for no mutants. */
        double percent() {
            return mutants == 0 ? 100 : 100.0 * killed / mutants;
        }

        private String columns() {
            return String.format(Locale.ROOT, "%7d  %6d  %9d  %5.1f", mutants, killed, timedOut, percent());
        }
    }

    private final Map<String, Count> rows = new TreeMap<>();

    /**
     * @param csv lines of file, class, mutator, method, line, status, test
     * @return a row for each top-level class, including nested ones
     * @throws IllegalArgumentException if a line is not of that kind
     */
    static MutationTable ofClasses(List<String> csv) {
        MutationTable table = new MutationTable();
        for (String line : csv) {
            String[] cells = line.split(",");
            if (cells.length < 6) {
                throw new IllegalArgumentException("not a line about a mutant: " + line);
            }
            boolean survived = cells[5].equals("SURVIVED") || cells[5].equals("NO_COVERAGE");
            String name = cells[1].replaceFirst("\\$.*", "");
            table.add(name.substring(name.lastIndexOf('.') + 1),
                    new Count(1, survived ? 0 : 1, cells[5].equals("TIMED_OUT")
                    ? 1 : 0));
        }
        return table;
    }

    void add(String row, Count count) {
        rows.merge(row, count, Count::plus);
    }

    Count total() {
        return rows.values().stream().reduce(Count.NONE, Count::plus);
    }

    /** The names of the rows with a lower percentage. */
    List<String> below(double percent) {
        return rows.keySet().stream().filter(row -> rows.get(row).percent() < percent).toList();
    }

    /** As text, with a line of names above and one of sums below. */
    String print(String what) {
        int width = rows.keySet().stream().mapToInt(String::length).max().orElse(0);
        String format = "%-" + Math.max(width, what.length()) + "s  %s%n";
        StringBuilder text = new StringBuilder(format.formatted(what, "mutants  killed  timed out      %"));
        rows.forEach((row, count) -> text.append(format.formatted(row, count.columns())));
        return text.append(format.formatted("all", total().columns())).toString();
    }
}
