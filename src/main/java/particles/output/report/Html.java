package particles.output.report;

import java.util.Arrays;
import java.util.HashSet;
import java.util.Set;

/** Escapes text for HTML that is well-formed XML too. */
public final class Html {
    /** What XML 1.0 does not allow. */
    private static final String NO_CHARACTER = "[^\\t\\n\\r\\u0020-\\uD7FF\\uE000-\\uFFFD\\x{10000}-\\x{10FFFF}]";

    private final Set<String> ids = new HashSet<>();

    /** @return the text with all characters replaced that are special or not allowed in HTML */
    static String escaped(String text) {
        return text.replaceAll(NO_CHARACTER, "\ufffd").replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
                .replace("\"", "&quot;");
    }

    /** @return the template with these texts, escaped, in place of each %s */
    public static String fill(String template, Object... texts) {
        return template.formatted(Arrays.stream(texts).map(text -> escaped(text.toString())).toArray());
    }

    /** @return a name for an element, made of this text, that no other element of this page has */
    String id(String text) {
        String plain = text.replaceAll("[^A-Za-z0-9]+", "-").replaceAll("^(?![A-Za-z])", "n");
        String id = plain;
        for (int k = 2; !ids.add(id); k++) {
            id = plain + "-" + k;
        }
        return id;
    }
}
