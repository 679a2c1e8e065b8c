package particles.spec.messages;

import deSolvers.text.DidYouMean;
import java.util.Collection;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.snakeyaml.engine.v2.nodes.MappingNode;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.ScalarNode;
import org.snakeyaml.engine.v2.nodes.SequenceNode;
import org.snakeyaml.engine.v2.nodes.Tag;

/** Building blocks of messages: quoted text, unknown names with suggestions, numbers; always one line. */
public final class Wording {
    /** Quotation marks of printed text, for a character class. */
    public static final String CURLY_QUOTES = "\u2018-\u201f\u00ab\u00bb";

    private static final int LONGEST_QUOTE = 40;
    /** For a key of more parts than this, such as 'position', a hint at the parts would be useless. */
    private static final int MOST_OWNERS = 5;
    private static final int LONGEST_MESSAGE = 1000;
    /** Characters without width or with a direction, and spaces that look like the ordinary one. */
    private static final Pattern INVISIBLE = Pattern.compile("[\\p{Cf}\\xa0\\u2007\\u202f]");

    private Wording() {
    }

    /**
     * @param text any text
     * @return it in single quotes, cut if it is long, with control characters replaced
     */
    public static String quote(String text) {
        String shown = text.codePointCount(0, text.length()) > LONGEST_QUOTE
                ? text.substring(0, text.offsetByCodePoints(0, LONGEST_QUOTE - 3)) + "..." : text;
        return quoteWhole(shown);
    }

    /**
     * @param text a text that is of no use if it is cut, such as a path
     * @return it in single quotes, with control characters replaced
     */
    public static String quoteWhole(String text) {
        return "'" + oneLine(text) + "'";
    }

    /**
     * @param what   the kind of thing that has the name, such as {@code effect}
     * @param found  the unknown name
     * @param known  the names that are allowed
     * @param owners the parts of a scene in which it is a key; named if no known name is similar
     * @return {@code unknown effect 'gravty'; did you mean 'gravity'? known: ...}
     */
    public static String unknown(String what, String found, Collection<String> known, List<String> owners) {
        return unknown(what, found, known, owners, "known");
    }

    /** As above; the known names are introduced as {@code known in effects}. */
    public static String unknown(String what, String found, Collection<String> known, List<String> owners,
            String introduction) {
        String hint = hint(found, known);
        boolean misplaced = hint.equals(";") && !owners.isEmpty() && owners.size() <= MOST_OWNERS;
        return "unknown " + what + " " + quote(found)
                + (misplaced ? "; it is a key of " + String.join(", ", owners) + ";" : hint) + " " + introduction + ": "
                + String.join(", ", known);
    }

    /**
     * @param found an unknown name
     * @param known the names that are allowed
     * @return {@code "; did you mean 'gravity'?"}, or {@code ";"} if no name is similar
     */
    public static String hint(String found, Collection<String> known) {
        return found.length() > LONGEST_QUOTE ? ";" : DidYouMean.hint(found, known, Wording::quote);
    }

    /** @return the names, or the first of them if there are many */
    public static String some(List<String> names) {
        return names.size() <= 12 ? String.join(", ", names) : String.join(", ", names.subList(0, 12)) + " ...";
    }

    /** Describes a node in words. */
    public static String describe(Node node) {
        if (node instanceof MappingNode) {
            return "a mapping (key: value)";
        }
        if (node instanceof SequenceNode sequence) {
            List<Node> items = sequence.getValue();
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

    /** Makes a text one line and writes invisible or direction-changing characters as codes such as U+200B. */
    static String oneLine(String text) {
        String plain = text.replaceAll("[\\p{Cntrl}\\u0085\\u2028\\u2029]+", " ");
        String line = plain.codePoints().mapToObj(c -> new String(Character.toChars(c)))
                .map(character -> INVISIBLE.matcher(character).matches()
                        ? String.format("U+%04X", character.codePointAt(0)) : character).collect(Collectors.joining());
        return line.length() > LONGEST_MESSAGE ? line.substring(0, LONGEST_MESSAGE) + " ..." : line;
    }
}
