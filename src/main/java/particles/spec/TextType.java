package particles.spec;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.ScalarNode;
import org.snakeyaml.engine.v2.nodes.Tag;

/**
 * The type of a text, optionally of a certain form.
 *
 * @param describe    the text's meaning and allowed form
 * @param pattern     has to be found in the text
 * @param alsoNumbers whether it may be a number, true or false; the value is what was typed
 * @param longest     the largest number of characters
 */
public record TextType(String describe, Pattern pattern, boolean alsoNumbers, int longest) implements Type<String> {
    private static final int LONGEST = 2000;
    /** All but tabs and ends of lines. */
    private static final String CONTROL = "\\x00-\\x08\\x0b\\x0c\\x0e-\\x1f\\x7f-\\x9f";
    private static final Pattern FORBIDDEN = Pattern.compile("[" + CONTROL + "]");
    private static final Pattern VISIBLE = Pattern.compile("\\S");
    private static final TextType PROSE = new TextType("a text that is not empty, without control characters",
            Pattern.compile("^[^" + CONTROL + "]*[^\\s" + CONTROL + "][^" + CONTROL + "]*$"), false, LONGEST);

    /** @return the type of any text that is not empty; control characters would make files unreadable */
    public static TextType prose() {
        return PROSE;
    }

    /**
     * @param description the text's meaning and allowed form
     * @param pattern     a regular expression that means the same in Java and in ECMA 262; it has to be found in the
     *                    text
     * @return the type of texts of that form
     */
    public static TextType of(String description, String pattern) {
        return new TextType(description, Pattern.compile(pattern), false, LONGEST);
    }

    /** @return the type of a text, a number or true or false; its value is what was typed */
    public static TextType typed(String description) {
        return new TextType(description, Pattern.compile(""), true, LONGEST);
    }

    /** @return the type of a text of any length, such as the contents of a file */
    public static TextType contents(String description) {
        return new TextType(description, Pattern.compile(""), true, SourceText.LARGEST);
    }

    /** In the page a pattern of a long text takes the stack for each character: prose is searched in two ways. */
    boolean matches(String text) {
        return text.codePointCount(0, text.length()) <= longest && (this == PROSE
                ? VISIBLE.matcher(text).find() && !FORBIDDEN.matcher(text).find() : isFound(text));
    }

    /** In Java a $ also stands before an end of line that ends the text. */
    private boolean isFound(String text) {
        Matcher matcher = pattern.matcher(text);
        return matcher.find() && (matcher.end() == text.length() || !pattern.pattern().endsWith("$"));
    }

    @Override
    public Optional<String> read(Node node, String what, Reading in) {
        if (!(node instanceof ScalarNode scalar)) {
            return wrong(node, what, in);
        }
        String text = scalar.getValue();
        if (!alsoNumbers && !node.getTag().equals(Tag.STR)) {
            return wrong(node, what, "it has to be " + describe() + ": put quotes around it, '" + text + "'", in);
        }
        return matches(text) ? Optional.of(text) : wrong(node, what, in);
    }
}
