package particles.output.report;

import java.util.HashSet;
import java.util.Set;

/** Escapes text for HTML that is well-formed XML too. */
final class Html {
    private final Set<String> ids = new HashSet<>();

    /** @return the text with all characters replaced that are special or not allowed in HTML */
    static String escaped(String text) {
        StringBuilder safe = new StringBuilder();
        text.codePoints().forEach(c -> {
            switch (c) {
                case '&' -> safe.append("&amp;");
                case '<' -> safe.append("&lt;");
                case '>' -> safe.append("&gt;");
                case '"' -> safe.append("&quot;");
                default -> safe.appendCodePoint(isCharacter(c) ? c : 0xfffd);
            }
        });
        return safe.toString();
    }

    /** Whether XML 1.0 allows a character. */
    private static boolean isCharacter(int c) {
        return c == '\t' || c == '\n' || c == '\r' || c >= ' ' && c < 0xd800 || c >= 0xe000 && c < 0xfffe
                || c >= 0x10000;
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
