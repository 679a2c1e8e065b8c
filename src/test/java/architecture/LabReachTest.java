package architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.spi.ToolProvider;
import org.junit.jupiter.api.Test;
import particles.lab.Session;

/**
 * Checks that the classes compiled for the lab's page use no threads, files, reflection or anything else that a browser
 * lacks. Dependencies are read from the compiled classes by jdeps.
 */
class LabReachTest {
    private static final Pattern EDGE = Pattern.compile("(?m)^ +((?:deSolvers|particles)\\.\\S+) +-> (\\S+)");
    private static final Pattern MISSING = Pattern.compile(
            "java\\.lang\\.(Thread|Process|ClassLoader|reflect\\.).*|java\\.util\\.concurrent\\..*"
            + "|java\\.nio\\.(file|channels)\\..*|java\\.io\\.(File|RandomAccess).*|java\\.security\\..*"
            + "|java\\.net\\..*|java\\.util\\.HexFormat|javax\\..*|java\\.awt\\..*");

    /** What is formatted in a text, and the conversions that the page's String.format has: no %e, %g or %n. */
    private static final Pattern CONVERSION = Pattern.compile("%[-+0,(#]*\\d*(?:\\.\\d+)?([a-zA-Z])");
    private static final String CONVERSIONS = "bcdfhosxBCDHOSX";

    /** Classes compiled without the method that uses these: the page replaces it, or never calls it. */
    private static final Map<String, Set<String>> NOT_CALLED = Map.of(
            "deSolvers.catalog.SolverCatalog", Set.of("java.lang.Thread", "java.lang.reflect.Constructor",
                    "java.lang.reflect.InvocationTargetException", "java.lang.ClassLoader"),
            "particles.scene.SceneReader", Set.of("java.nio.file.Path"),
            "particles.spec.SourceText", Set.of("java.nio.file.Path", "java.nio.file.Files", "java.nio.file.LinkOption",
                    "java.nio.file.OpenOption", "java.nio.file.AccessDeniedException",
                    "java.nio.file.NoSuchFileException"));

    private static Map<String, Set<String>> uses() throws Exception {
        StringWriter out = new StringWriter();
        String classes = Session.class.getProtectionDomain().getCodeSource().getLocation().getPath();
        int exit = ToolProvider.findFirst("jdeps").orElseThrow().run(new PrintWriter(out), new PrintWriter(out),
                "-verbose:class", "-filter:none", "--ignore-missing-deps", "--multi-release", "17", classes);
        assertEquals(0, exit, out.toString());
        Map<String, Set<String>> uses = new TreeMap<>();
        Matcher edge = EDGE.matcher(out.toString());
        while (edge.find()) {
            uses.computeIfAbsent(edge.group(1), name -> new TreeSet<>()).add(edge.group(2));
        }
        return uses;
    }

    private static Set<String> reached(Map<String, Set<String>> uses, String from) {
        Set<String> reached = new TreeSet<>(Set.of(from));
        Deque<String> open = new ArrayDeque<>(reached);
        while (!open.isEmpty()) {
            for (String used : uses.getOrDefault(open.remove(), Set.of())) {
                if (reached.add(used)) {
                    open.add(used);
                }
            }
        }
        return reached;
    }

    private static Set<String> missing(Map<String, Set<String>> uses, Set<String> reached) {
        Set<String> found = new TreeSet<>();
        for (String name : reached) {
            for (String used : uses.getOrDefault(name, Set.of())) {
                if (MISSING.matcher(used).matches() && !NOT_CALLED.getOrDefault(name, Set.of()).contains(used)) {
                    found.add(name + " uses " + used);
                }
            }
        }
        return found;
    }

    @Test
    void thePageReachesNothingThatABrowserLacks() throws Exception {
        Map<String, Set<String>> uses = uses();
        Set<String> reached = reached(uses, Session.class.getName());
        assertTrue(reached.contains("deSolvers.RK4Solver"), reached.toString());
        assertTrue(reached.contains("particles.Simulation"), reached.toString());
        assertEquals(Set.of(), missing(uses, reached));
        Set<String> found = missing(uses, reached(uses, "particles.app.Main"));
        assertTrue(found.toString().matches(".*uses java.lang.Thread[,\\]].*uses java.nio.file.Files[,\\]].*"),
                "the whole program uses both: " + found);
    }

    private static Set<String> unknownFormats(Set<String> reached) throws IOException {
        Set<String> unknown = new TreeSet<>();
        for (String name : reached) {
            Path source = Path.of("src/main/java", name.replaceFirst("\\$.*", "").replace('.', '/') + ".java");
            String text = Files.exists(source) ? Files.readString(source) : "";
            Matcher conversion = CONVERSION.matcher(text.matches("(?s).*(\\.format\\(|formatted\\().*") ? text : "");
            while (conversion.find()) {
                if (!CONVERSIONS.contains(conversion.group(1))) {
                    unknown.add(source.getFileName() + " formats with " + conversion.group());
                }
            }
        }
        return unknown;
    }

    @Test
    void thePageKnowsEveryFormatThatItsClassesUse() throws Exception {
        Map<String, Set<String>> uses = uses();
        assertEquals(Set.of(), unknownFormats(reached(uses, Session.class.getName())));
        Set<String> found = unknownFormats(reached(uses, "particles.app.Main"));
        assertTrue(found.stream().anyMatch(line -> line.endsWith("formats with %.8g")), "charts do: " + found);
    }
}
