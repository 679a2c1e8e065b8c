package particles.output.report;

import com.samskivert.mustache.DefaultCollector;
import com.samskivert.mustache.Mustache;
import java.util.Iterator;
import java.util.Optional;
import particles.output.files.Numbers;

/**
 * Fills templates of pages: {@code {{name}}} stands for a text, and what is between {@code {{#name}}} and {@code
 * {{/name}}} is repeated for each item of a list, or left out. Texts are escaped for HTML that is well-formed XML too.
 */
public final class Html {
    /** What XML 1.0 does not allow. */
    private static final String NO_CHARACTER = "[^\\t\\n\\r\\u0020-\\uD7FF\\uE000-\\uFFFD\\x{10000}-\\x{10FFFF}]";
    static final Mustache.Compiler TEMPLATES = Mustache.compiler().withEscaper(Html::escaped)
            .withFormatter(value -> value instanceof Double number ? Numbers.shortest(number) : value.toString())
            .withCollector(new DefaultCollector() {
                @Override
                public Iterator<?> toIterator(Object value) {
                    return value instanceof Optional<?> one ? one.stream().iterator() : super.toIterator(value);
                }
            });

    private Html() {
    }

    /** @return the text with all characters replaced that are special or not allowed in HTML */
    static String escaped(String text) {
        return text.replaceAll(NO_CHARACTER, "\ufffd").replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
                .replace("\"", "&quot;");
    }

    /**
     * @param template a template
     * @param model    a map or a record; its entries or components are the names in the template
     * @return the page
     */
    public static String fill(String template, Object model) {
        return TEMPLATES.compile(template).execute(model);
    }
}
