package deSolvers.text;

import java.util.Collection;
import java.util.Comparator;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.UnaryOperator;

/** Suggests the known name that was probably meant, for messages about unknown names. */
public final class DidYouMean {
    private static final int LONGEST_BEGINNING = 5;
    /** What other programs and books call the same, in lower case. */
    private static final Map<String, String> OTHER_WORDS = Map.of("dt", "deltaT", "h", "deltaT", "step", "deltaT",
            "timestep", "deltaT", "integrator", "solver", "method", "solver", "fps", "frameRate", "k", "stiffness",
            "m", "mass");

    private DidYouMean() {
    }

    /**
     * @param found a name that is not known
     * @param known the names that are
     * @return the known name that means the same or is nearest, if one is near: one wrong letter in three, or the same
     *         first letters; one or two letters are near only to the same letters in the other case
     */
    public static Optional<String> nearest(String found, Collection<String> known) {
        String lower = found.toLowerCase(Locale.ROOT);
        String other = OTHER_WORDS.getOrDefault(lower, "");
        if (known.contains(other) || lower.length() <= 2) {
            return known.stream().filter(name -> name.equals(other) || name.equalsIgnoreCase(found)).findFirst();
        }
        Comparator<String> byDistance = Comparator.comparingInt(name -> distance(lower, name.toLowerCase(Locale.ROOT)));
        Optional<String> nearest = known.stream().min(byDistance)
                .filter(name -> distance(lower, name.toLowerCase(Locale.ROOT))
                        <= Math.max(1, Math.min(lower.length(), name.length()) / 3));
        String beginning = lower.substring(0, Math.min(lower.length(), LONGEST_BEGINNING));
        return nearest.or(() -> known.stream().filter(name -> name.toLowerCase(Locale.ROOT).startsWith(beginning))
                .min(Comparator.naturalOrder()));
    }

    /**
     * @param found a name that is not known
     * @param known the names that are
     * @param write formats a name for the message
     * @return {@code "; did you mean X?"}, or {@code ";"} if nothing is near; the message goes on with the known names
     */
    public static String hint(String found, Collection<String> known, UnaryOperator<String> write) {
        return nearest(found, known).map(name -> "; did you mean " + write.apply(name) + "?").orElse(";");
    }

    /** Insertions, deletions, replacements and swaps of neighbours that make one word of the other. */
    private static int distance(String a, String b) {
        int[][] d = new int[a.length() + 1][b.length() + 1];
        for (int i = 0; i <= a.length(); i++) {
            for (int j = 0; j <= b.length(); j++) {
                if (i == 0 || j == 0) {
                    d[i][j] = i + j;
                    continue;
                }
                int replaced = d[i - 1][j - 1] + (a.charAt(i - 1) == b.charAt(j - 1) ? 0 : 1);
                d[i][j] = Math.min(replaced, 1 + Math.min(d[i - 1][j], d[i][j - 1]));
                if (i > 1 && j > 1 && a.charAt(i - 1) == b.charAt(j - 2) && a.charAt(i - 2) == b.charAt(j - 1)) {
                    d[i][j] = Math.min(d[i][j], d[i - 2][j - 2] + 1);
                }
            }
        }
        return d[a.length()][b.length()];
    }
}
