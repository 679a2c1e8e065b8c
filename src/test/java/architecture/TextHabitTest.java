package architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * A string is for a person: the program takes no title, label, finding or message of its own apart, and reads no table
 * from a text. What users type, and names of files, are read where they come in.
 */
class TextHabitTest {
    private static final Path MAIN = Path.of("src/main/java");
    private static final String TAKES_APART = "(replaceFirst|replaceAll|split|matches|startsWith|endsWith"
            + "|contains|substring|indexOf|lastIndexOf)";
    /** A variable or an accessor with the name of a text for people, from which something is taken. */
    private static final Pattern OWN_TEXT = Pattern.compile("\\b(title|label|heading|headline|caption|finding|answer"
            + "|remark|sentence|verdict|identity|message|quantity|slope|words|purpose|(get)?(Title|Message|Label))"
            + "(\\(\\))?\\s*\\." + TAKES_APART + "\\(", Pattern.CASE_INSENSITIVE);
    /** A pattern on such a text. */
    private static final Pattern MATCHED = Pattern.compile("\\.matcher\\((\\w+\\.)*(title|label|heading|headline"
            + "|caption|finding|answer|remark|sentence|verdict|identity|message|getMessage)\\b",
            Pattern.CASE_INSENSITIVE);
    /** Rows of a text, each of them split: a table that no compiler checks. */
    private static final Pattern ROWS = Pattern.compile("[.]split[(]\"( = | ?\\[[|]\\] ?)\"");

    /** A tableau in the shape in which textbooks print it. */
    private static final String PRINTED = "ButcherTableau.java";
    private static final Pattern COMMENT = Pattern.compile("/[*].*?[*]/|(?m)^\\s*//[^\n]*", Pattern.DOTALL);

    private static List<String> habits(String code) {
        String bare = COMMENT.matcher(code).replaceAll("");
        return Stream.of(OWN_TEXT, MATCHED, ROWS).flatMap(pattern -> pattern.matcher(bare).results())
                .map(MatchResult::group).toList();
    }

    @Test
    void noTextOfOursIsTakenApart() throws IOException {
        List<String> wrong = new ArrayList<>();
        try (Stream<Path> files = Files.walk(MAIN)) {
            for (Path file : files.filter(file -> file.toString().endsWith(".java")).sorted().toList()) {
                String place = MAIN.relativize(file).toString().replace('\\', '/');
                if (!place.endsWith(PRINTED)) {
                    habits(Files.readString(file)).forEach(habit -> wrong.add(place + ": " + habit));
                }
            }
        }
        assertEquals(List.of(), wrong);
    }

    /** Each of these was in the program until its charts, tables and claims were typed. */
    @ParameterizedTest
    @ValueSource(strings = {"// said\ntitle.replaceFirst(\": \", whose)",
        "axis.getLabel().replaceFirst(\".*\", \"$1\")",
        "String heading = chart.title().substring(2);", "COMMA.matcher(finding.title()).find()",
        "TABLE.lines().map(line -> line.split(\" [|] \"))", "row.split(\" = \")", "e.getMessage()\n    .split(\"x\")"})
    void theHabitIsSeen(String code) {
        assertEquals(1, habits(code).size(), code);
    }

    @ParameterizedTest
    @ValueSource(strings = {"title.equals(other.title())", "typed.split(\",\")", "/* title.split(a) */",
        "\"the title. split\"", "// title\ntext.split(a)", "title.replace(quote, escaped)"})
    void otherCodeIsNot(String code) {
        assertEquals(List.of(), habits(code));
    }
}
