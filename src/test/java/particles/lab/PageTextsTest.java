package particles.lab;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** All texts of the page stand in one file, so that there can be a second language. */
class PageTextsTest {
    private static final Path PAGE = Path.of("src/main/java/particles/lab/page");
    private static final Pattern TOKEN = Pattern.compile(
            "//[^\n]*|(?s:/\\*.*?\\*/)|'((?:\\\\.|[^'\\\\\n])*)'|\"((?:\\\\.|[^\"\\\\\n])*)\"|`((?:\\\\.|[^`\\\\])*)`");
    private static final Pattern TWO_WORDS = Pattern.compile("[A-Za-z]{2,}[,;:.]? [A-Za-z]{2,}");
    /** What only shaders, markup, selectors, styles and scenes have. */
    private static final Pattern CODE = Pattern.compile("[#<>(){}\\[\\]]|;(\\\\n|\\s+)$|sans-serif$");
    /** The name of an energy, by which it gets its colour; and the kinds of elements that take a key themselves. */
    private static final Set<String> NAMES = Set.of("numerical error", "button, input, summary, a");
    /** A word, put where a person reads it; but for the name of a law. */
    private static final Pattern SHOWN = Pattern.compile("(?:(textContent|title|ariaLabel|placeholder|label|\\.text)"
            + "\\s*[:=]\\s*|(fillText|append|prepend|note|told|tell|new Option)\\()"
            + "(?!'gravity')('[^'\n]*?[A-Za-z]{2}|`[A-Za-z]{2})");
    private static final Pattern ATTRIBUTE = Pattern.compile("\\b(aria-label|title|placeholder|alt)=");
    private static final Pattern MEMBER = Pattern.compile("TEXTS\\.(\\w+)");

    private static List<Path> scripts() throws IOException {
        try (Stream<Path> files = Files.list(PAGE)) {
            return files.filter(file -> file.toString().endsWith(".js")).sorted().toList();
        }
    }

    /** The strings of a script, and in them of what is computed nothing. */
    private static Stream<String> strings(String code) {
        return TOKEN.matcher(code).results().flatMap(token -> IntStream.rangeClosed(1, 3).mapToObj(token::group))
                .filter(Objects::nonNull).map(text -> text.replaceAll("\\$\\{[^}]*}", ""));
    }

    @Test
    void scriptsHoldNoTextThatAPersonReads() throws IOException {
        for (Path script : scripts()) {
            String code = Files.readString(script);
            if (!script.endsWith("texts.js")) {
                assertEquals(List.of(), strings(code).filter(TWO_WORDS.asPredicate()).filter(text ->
                        !CODE.matcher(text).find() && !NAMES.contains(text)).toList(), script.toString());
                assertEquals(List.of(), SHOWN.matcher(code).results().map(MatchResult::group).toList(),
                        script.toString());
            }
        }
    }

    @Test
    void thePageItselfHoldsItsNameAlone() throws IOException {
        String html = Files.readString(PAGE.resolve("index.html"));
        assertEquals(List.of("DESolver lab", "DESolver lab", "0 s", "0", "0", "0 s"), Stream.of(html.split("<[^>]*>"))
                .map(text -> text.replaceAll("&\\w+;", "").strip()).filter(text -> !text.isEmpty()).toList());
        assertEquals(0, ATTRIBUTE.matcher(html).results().count());
    }

    @Test
    void allTextsAreThereAndUsed() throws IOException {
        Set<String> used = new TreeSet<>();
        for (Path script : scripts()) {
            MEMBER.matcher(Files.readString(script)).results().forEach(found -> used.add(found.group(1)));
        }
        used.addAll(List.of("ariaLabel", "title", "placeholder"));              // which one loop takes
        String texts = TOKEN.matcher(Files.readString(PAGE.resolve("texts.js"))).replaceAll("''")
                .replaceAll("(?<=: )\\{[^{}]*}", "''")         // what stands in elements, one in the other
                .replaceAll("(?<=: )\\{[^{}]*}", "''");
        assertEquals(used, Pattern.compile("(\\w+): ").matcher(texts.substring(0, texts.indexOf("\n};"))).results()
                .map(found -> found.group(1)).collect(Collectors.toCollection(TreeSet::new)));
    }
}
