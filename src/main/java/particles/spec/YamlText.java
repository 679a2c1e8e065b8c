package particles.spec;

import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Function;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.snakeyaml.engine.v2.api.LoadSettings;
import org.snakeyaml.engine.v2.api.lowlevel.Compose;
import org.snakeyaml.engine.v2.api.lowlevel.Parse;
import org.snakeyaml.engine.v2.events.AliasEvent;
import org.snakeyaml.engine.v2.events.CollectionEndEvent;
import org.snakeyaml.engine.v2.events.CollectionStartEvent;
import org.snakeyaml.engine.v2.events.DocumentStartEvent;
import org.snakeyaml.engine.v2.events.Event;
import org.snakeyaml.engine.v2.events.NodeEvent;
import org.snakeyaml.engine.v2.events.ScalarEvent;
import org.snakeyaml.engine.v2.exceptions.Mark;
import org.snakeyaml.engine.v2.exceptions.MarkedYamlEngineException;
import org.snakeyaml.engine.v2.exceptions.YamlEngineException;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.schema.CoreSchema;
import particles.spec.messages.Place;
import particles.spec.messages.Wording;

/**
 * Parses YAML 1.2 (core schema, so that 1e-3 is a number) into a tree of nodes with places. Deep nesting, aliases (ten
 * lines can expand to a billion values) and too many values are refused before the tree is built, in one line each.
 */
public final class YamlText {
    private static final int DEEPEST = 20;
    private static final int MOST_VALUES = 200_000;
    /** Before an escape on which the parser itself fails: at the end of the text, or with a code larger than an int. */
    private static final Pattern NO_CHARACTER = Pattern.compile("(?=\\\\(?:[xuU]\\z|U[89A-Fa-f][0-9A-Fa-f]{7}))");
    private static final String WRONG_ESCAPE = "not valid YAML: an escape has to give a character's number in"
            + " hexadecimal digits, such as \\xe9, \\u00e9 or \\U000000e9";
    /** Before a line that begins with %, other than the head of a YAML 1 file. */
    private static final Pattern PERCENT = Pattern.compile("(?m)^(?=%(?!YAML 1[.]\\d+\\s|TAG ))");
    /** {@code deltaT:0.01} up to the colon, and the same after spaces of which one is not an ordinary space. */
    private static final Pattern NO_SPACE = Pattern.compile("^\\s*(?:-\\s+)?([A-Za-z]\\w*):(?=([^\\s/:].*))");
    private static final Pattern NO_BREAK_SPACE = Pattern.compile("(?=[\u00a0\u2007\u202f])");
    /** Before a quotation mark of printed text at the beginning of a value. */
    private static final Pattern CURLY_QUOTE = Pattern.compile(
            "(?:^|[:-]\\s|[\\[{,])\\s*(?=[" + Wording.CURLY_QUOTES + "])");

    private YamlText() {
    }

    /**
     * @param bytes the contents of a file
     * @param in    its name, and the list that receives problems
     * @return the root of its tree, or empty if a problem was reported
     */
    public static Optional<Node> compose(byte[] bytes, Reading in) {
        return SourceText.decode(bytes, in).flatMap(text -> compose(text, in));
    }

    private static Optional<Node> compose(String text, Reading in) {
        LoadSettings settings = LoadSettings.builder().setLabel(in.source()).setSchema(new CoreSchema())
                .setCodePointLimit(Integer.MAX_VALUE)
                .setAllowNonScalarKeys(true)            // refused by our own message
                .build();
        int before = in.problems().count();
        try {
            lookThrough(new Parse(settings).parseString(text), in);
            if (in.problems().count() > before) {
                return Optional.empty();
            }
            Optional<Node> root = new Compose(settings).composeString(text);
            if (root.isEmpty()) {
                in.problem("the file is empty");
            }
            return root;
        } catch (YamlEngineException e) {
            Optional<Mark> mark = e instanceof MarkedYamlEngineException marked ? marked.getProblemMark()
                    : Optional.empty();
            if (!report(PERCENT, text, 0, found -> "a line cannot begin with %; a comment begins with #", in)
                    && !typingMistake(text, mark.map(Mark::getLine).orElse(0), in)) {
                in.problems().add(Place.of(in.source(), mark), "not valid YAML: "
                        + (e instanceof MarkedYamlEngineException marked ? reason(marked, text) : e.getMessage()));
            }
        } catch (NumberFormatException e) {
            if (!report(NO_CHARACTER, text, 0, found -> WRONG_ESCAPE, in)) {
                in.problem(WRONG_ESCAPE);
            }
        }
        return Optional.empty();
    }

    /**
     * Looks for a typing mistake. The parser reports a mistake where it notices it, which can be a line too late.
     *
     * @param noticed the line in which the parser noticed something, from 0
     * @return whether a mistake was found and reported in that line or in the last line before it that is not empty
     */
    static boolean typingMistake(String text, int noticed, Reading in) {
        String[] lines = text.split("\n", -1);
        int looked = 0;
        for (int n = Math.min(noticed, lines.length - 1); n >= 0 && looked < 2; n--) {
            looked += lines[n].isBlank() ? 0 : 1;
            if (report(NO_BREAK_SPACE, lines[n], n, found -> "a no-break space is here, which YAML does not take for a"
                    + " space; type an ordinary space instead", in)
                    || report(NO_SPACE, lines[n], n, found -> "a space is missing after '" + found.group(1)
                    + ":'; write '" + found.group(1) + ": " + found.group(2).strip() + "'", in)
                    || looked < 2 && report(CURLY_QUOTE, lines[n], n, found -> "a curly quote is here, which YAML does"
                    + " not take for a quote; type an ordinary ' or \" instead", in)) {
                return true;
            }
        }
        return false;
    }

    /**
     * Reports a mistake if its pattern is found.
     *
     * @param mistake ends before the place to report
     * @param text    the whole text or a line of it
     * @param lines   the number of lines before it
     * @return whether it was found
     */
    private static boolean report(Pattern mistake, String text, int lines, Function<MatchResult, String> message,
                                  Reading in) {
        Matcher found = mistake.matcher(text);
        boolean is = found.find();
        if (is) {
            Place place = SourceText.end(text.substring(0, found.end()), in);
            in.problems().add(new Place(in.source(), lines + place.line(), place.column()), message.apply(found));
        }
        return is;
    }

    /** Refuses what could take too much memory, and what scenes do not use. */
    private static void lookThrough(Iterable<Event> events, Reading in) {
        int depth = 0;
        int values = 0;
        int documents = 0;
        for (Event event : events) {
            depth += event instanceof CollectionStartEvent ? 1 : event instanceof CollectionEndEvent ? -1 : 0;
            values += event instanceof NodeEvent ? 1 : 0;
            documents += event instanceof DocumentStartEvent ? 1 : 0;
            String limit = values > MOST_VALUES
                    ? "more than " + MOST_VALUES + " values; use shapes to make many particles"
                    : depth > DEEPEST ? "nested more than " + DEEPEST + " deep"
                    : documents > 1 ? "a second document begins; a file holds one scene" : "";
            Place place = Place.of(in.source(), event.getStartMark());
            if (!limit.isEmpty()) {
                in.problems().add(place, limit);
                return;
            }
            if (event instanceof NodeEvent node && (node instanceof AliasEvent || node.getAnchor().isPresent())) {
                in.problems().add(place, "anchors and aliases (&name, *name) are not used in scenes; write the values"
                        + " out, or put quotes around a text that begins with & or *");
            } else if (event instanceof ScalarEvent scalar && scalar.getTag().isPresent()
                    || event instanceof CollectionStartEvent start && start.getTag().isPresent()) {
                in.problems().add(place,
                        "tags (!name) are not used in scenes; put quotes around a text that begins with !");
            }
        }
    }

    /** The parser's reason, and the usual mistake behind it. */
    private static String reason(MarkedYamlEngineException e, String text) {
        String problem = e.getProblem() == null ? "the text ends too early or continues unexpectedly" : e.getProblem();
        int index = e.getProblemMark().map(Mark::getIndex).orElse(0);
        if (text.codePoints().skip(index).findFirst().equals(OptionalInt.of('\t'))) {
            return "a tab; YAML is indented by spaces";
        }
        if (problem.startsWith("mapping values are not allowed")) {
            return "this ':' cannot stand here; a text with a colon needs quotes, or the line is indented too far";
        }
        if (problem.startsWith("expected ',' or '") && e.getContextMark().isPresent()) {
            String found = problem.substring(problem.indexOf("but got ") + "but got ".length());
            String open = problem.contains("'}'") ? "{" : "[";
            return "the '" + open + "' of line " + (e.getContextMark().get().getLine() + 1) + " is not closed before "
                    + (found.equals("<stream end>") ? "the end" : found.startsWith("<")
                    ? "this; a comma or the closing bracket is missing" : "this '" + found + "'")
                    + (found.equals("[") ? " (an id such as cloth[3,4] needs quotes here)" : "");
        }
        if (problem.startsWith("expected <block end>")) {
            return problem.endsWith("'<scalar>'") ? "a text continues after its closing quote"
                    : "this line is not indented like the lines that it follows";
        }
        return problem + e.getContextMark().map(mark -> ", in the part that begins at line " + (mark.getLine() + 1))
                .orElse("");
    }
}
