package particles.spec.messages;

import deSolvers.catalog.DidYouMean;
import java.util.Collection;
import java.util.List;
import java.util.stream.Collectors;
import org.snakeyaml.engine.v2.nodes.MappingNode;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.ScalarNode;
import org.snakeyaml.engine.v2.nodes.SequenceNode;
import org.snakeyaml.engine.v2.nodes.Tag;

/** How messages say things: always in one line, never with more of the file's text than one wants to read. */
public final class Wording {
    private static final int LONGEST_QUOTE = 40;
    private static final int LONGEST_MESSAGE = 1000;

    private Wording() {
    }

    /**
     * @param text any text
     * @return it in single quotes, cut if it is long, with control characters replaced
     */
    public static String quote(String text) {
        String shown = text.codePointCount(0, text.length()) > LONGEST_QUOTE
                ? text.substring(0, text.offsetByCodePoints(0, LONGEST_QUOTE - 3)) + "..." : text;
        return "'" + oneLine(shown) + "'";
    }

    /**
     * @param what  what kind of name it is
     * @param found the unknown name
     * @param known the names that are allowed
     * @return {@code unknown effect 'gravty'; did you mean 'gravity'? known: ...}
     */
    public static String unknown(String what, String found, Collection<String> known) {
        return "unknown " + what + " " + quote(found) + hint(found, known) + " known: " + String.join(", ", known);
    }

    /**
     * @param found an unknown name
     * @param known the names that are allowed
     * @return {@code "; did you mean 'gravity'?"}, or {@code ";"} if nothing is near, or everything is,
             as with one or two letters
     */
    public static String hint(String found, Collection<String> known) {
        return found.length() < 3 || found.length() > LONGEST_QUOTE ? ";" : DidYouMean.hint(found, known,
                Wording::quote);
    }

    /** @return the names, or the first of them if there are many */
    public static String some(List<String> names) {
        return names.size() <= 12 ? String.join(", ", names) : String.join(", ", names.subList(0, 12)) + " ...";
    }

    /** What a node is, in words. */
    public static String describe(Node node) {
        if (node instanceof MappingNode) {
            return "a mapping (key: value)";
        }
        if (node instanceof SequenceNode) {
            List<Node> items = ((SequenceNode) node).getValue();
            return items.size() > 3 || !items.stream().allMatch(ScalarNode.class::isInstance) ? "a list"
                    : items.stream().map(item -> quote(((ScalarNode) item).getValue()).replace("'", ""))
                            .collect(Collectors.joining(", ", "[", "]"));
        }
        String text = ((ScalarNode) node).getValue();
        if (node.getTag().equals(Tag.NULL)) {
            return "nothing";
        }
        return node.getTag().equals(Tag.STR) ? "the text " + quote(text) : quote(text).replace("'", "");
    }

    /** @return the number as people write it: 20 for 20.0, 1e20 for 1.0E20 */
    public static String number(double value) {
        if (value == StrictMath.rint(value) && Math.abs(value) < 1e7) {
            return Long.toString((long) value);
        }
        return Double.toString(value).replace(".0E", "e").replace('E', 'e');
    }

    static String oneLine(String text) {
        String line = text.replaceAll("[\\p{Cntrl}\\u0085\\u2028\\u2029]+", " ");
        return line.length() > LONGEST_MESSAGE ? line.substring(0, LONGEST_MESSAGE) + " ..." : line;
    }
}
