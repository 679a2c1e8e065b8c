package architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Function;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Who may use whom: the solvers know nothing of particles, the physics nothing of files or pictures, and only the command
 * line prints. Read from the sources themselves, imports and fully-qualified names alike.
 */
class ArchitectureTest {
    private static final Path MAIN = Path.of("src/main/java");
    private static final int MOST_LINES = 300;

    private static final String ALGEBRA = "org.ejml", YAML = "org.snakeyaml",
            JSON = "com.fasterxml.jackson", COMMAND_LINE = "picocli",
            CHARTS = "org.jfree", FILMS = "org.jcodec", XML = "javax.xml", COMPILER = "javax.tools", PAGE = "org.teavm", AWT = "java.awt",
                    IMAGES = "javax.imageio";
    private static final String EVERYTHING_OF_OURS = "*";

    /**
     * What a package may use besides itself and the plain JDK; a name that ends in a dot stands for all packages below it.
     * A package two levels down, such as particles.experiments.problems, has the rights of the one it is in, and may be
     * used like it.
     */
    private static final Map<String, Set<String>> MAY_USE = new TreeMap<>(Map.ofEntries(
            Map.entry("deSolvers", Set.of()),
            Map.entry("deSolvers.rungeKutta", Set.of("deSolvers")),
            Map.entry("deSolvers.adaptive", Set.of("deSolvers", "deSolvers.rungeKutta")),
            Map.entry("deSolvers.extrapolation", Set.of("deSolvers", "deSolvers.rungeKutta", "deSolvers.adaptive")),
            Map.entry("deSolvers.multistep", Set.of("deSolvers", "deSolvers.rungeKutta")),
            Map.entry("deSolvers.symplectic", Set.of("deSolvers")),
            Map.entry("deSolvers.linear", Set.of("deSolvers", ALGEBRA)),
            Map.entry("deSolvers.implicit", Set.of("deSolvers", "deSolvers.rungeKutta", "deSolvers.adaptive", "deSolvers.linear")),
            Map.entry("deSolvers.catalog", Set.of("deSolvers", "deSolvers.rungeKutta", "deSolvers.adaptive",
                    "deSolvers.extrapolation", "deSolvers.multistep", "deSolvers.symplectic", "deSolvers.implicit")),
            Map.entry("deSolvers.problems", Set.of("deSolvers")),
            Map.entry("particles", Set.of("deSolvers")),
            Map.entry("particles.spec", Set.of("deSolvers.catalog", "particles", YAML, JSON)),
            Map.entry("particles.effects", Set.of("particles", "particles.spec")),
            Map.entry("particles.reactions", Set.of("particles", "particles.effects", ALGEBRA)),
            Map.entry("particles.rules", Set.of("particles", "particles.effects", "particles.reactions")),
            Map.entry("particles.scene", Set.of("deSolvers", "deSolvers.catalog", "particles", "particles.effects",
                    "particles.reactions", "particles.rules", "particles.spec")),
            Map.entry("particles.experiments", Set.of("deSolvers", "deSolvers.catalog", "deSolvers.problems", "particles",
                    "particles.effects", "particles.reactions", "particles.rules", "particles.scene", ALGEBRA)),
            Map.entry("particles.output", Set.of("particles", CHARTS, AWT, IMAGES, FILMS, JSON, XML)),
            Map.entry("particles.teaching", Set.of("deSolvers", "deSolvers.", "particles", "particles.effects",
                    "particles.reactions",
                    "particles.rules", "particles.spec", "particles.scene", "particles.experiments")),
            Map.entry("particles.messages", Set.of("deSolvers", "deSolvers.adaptive", "deSolvers.catalog", "particles",
                    "particles.effects", "particles.reactions", "particles.experiments", "particles.scene")),
            Map.entry("particles.lab", Set.of("deSolvers", "deSolvers.catalog", "particles", "particles.effects",
                    "particles.experiments", "particles.messages", "particles.scene", "particles.spec", PAGE, COMPILER)),
            Map.entry("particles.app", Set.of(EVERYTHING_OF_OURS, COMMAND_LINE, JSON, COMPILER))));

    private final List<SourceFile> sources = SourceFile.readAll(MAIN).stream()
            .filter(source -> !source.packageName().equals("exercises")).toList();

    @Test
    void sourcesAreRead() {
        assertTrue(sources.stream().anyMatch(source -> source.toString().equals("deSolvers/RK4Solver.java")), sources.toString());
    }

    @Test
    void everyPackageUsesOnlyWhatItMay() {
        List<String> wrong = new ArrayList<>();
        for (SourceFile source : sources) {
            Set<String> allowed = MAY_USE.get(inTable(source.packageName()));
            if (allowed == null) {
                wrong.add(source + ": the package is not in the table");
                continue;
            }
            for (String used : source.usedPackages()) {
                if (!inTable(used).equals(inTable(source.packageName())) && !isAllowed(inTable(used), allowed)) {
                    wrong.add(source + " uses " + used);
                }
            }
        }
        assertNone(wrong);
    }

    private static String inTable(String name) {
        return isOurs(name) ? name.replaceFirst("^(\\w+\\.\\w+)\\..*", "$1") : name;
    }

    private static boolean isAllowed(String used, Set<String> allowed) {
        if (isOurs(used)) {
            return allowed.contains(used) || allowed.contains(EVERYTHING_OF_OURS) && !used.startsWith("exercises")
                    || allowed.stream().anyMatch(name -> name.endsWith(".") && used.startsWith(name));
        }
        boolean plainJdk = used.startsWith("java.") && !isIn(used, AWT);
        return plainJdk || allowed.stream().anyMatch(name -> isIn(used, name));
    }

    private static boolean isOurs(String used) {
        return isIn(used, "deSolvers") || isIn(used, "particles") || isIn(used, "exercises");
    }

    private static boolean isIn(String used, String parent) {
        return used.equals(parent) || used.startsWith(parent + ".");
    }

    @Test
    void packagesUseEachOtherWithoutCycles() {
        Map<String, Set<String>> uses = new TreeMap<>();
        for (SourceFile source : sources) {
            source.usedPackages().stream().filter(used -> isOurs(used) && !used.equals(source.packageName()))
                    .forEach(used -> uses.computeIfAbsent(source.packageName(), name -> new TreeSet<>()).add(used));
        }
        assertEquals("", cycle(uses));
    }

    @Test
    void tableItselfHasNoCycles() {
        Map<String, Set<String>> table = new TreeMap<>();
        MAY_USE.forEach((name, allowed) -> table.put(name, new TreeSet<>(MAY_USE.keySet().stream()
                .filter(other -> !other.equals(name) && isAllowed(other, allowed)).toList())));
        assertEquals("", cycle(table));
    }

    /** Takes away what uses nothing that is left, until nothing is left, or a cycle. */
    private static String cycle(Map<String, Set<String>> uses) {
        Map<String, Set<String>> left = new TreeMap<>(uses);
        while (left.entrySet().removeIf(entry -> entry.getValue().stream().noneMatch(left::containsKey))) {
            assertTrue(left.size() < uses.size());
        }
        return left.isEmpty() ? "" : left.toString();
    }

    @Test
    void noFileIsLong() {
        assertNone(sources.stream().filter(source -> source.lines() > MOST_LINES).map(source -> source + " has "
                + source.lines() + " lines").toList());
    }

    @Test
    void onlyTheCommandLinePrintsAndExits() {
        assertNone(findings(SourceFile::standardStreams, source -> !source.packageName().equals("particles.app")));
    }

    @Test
    void noExceptionIsCaughtAndForgotten() {
        assertNone(findings(SourceFile::emptyCatches, source -> true));
    }

    @Test
    void noStaticIsMutable() {
        assertNone(findings(SourceFile::mutableStatics, source -> true));
    }

    private List<String> findings(Function<SourceFile, List<String>> of, Function<SourceFile, Boolean> where) {
        return sources.stream().filter(where::apply).flatMap(source -> of.apply(source).stream()).toList();
    }

    private static void assertNone(List<String> wrong) {
        assertTrue(wrong.isEmpty(), () -> String.join(System.lineSeparator(), wrong));
    }

    /** The test's own test: every offence is seen, and only offences are. */
    @Test
    void offencesAreSeen(@TempDir Path folder) throws IOException {
        Files.writeString(folder.resolve("Bad.java"), """
                package deSolvers;
                import particles.effects.*;
                import static org.ejml.UtilEjml.EPS;
                class Bad {
                    static int count;
                    static final double[] TABLE = {1};
                    private static final double[] FINE = {1};
                    static final java.util.List<String> NAMES = new java.util.ArrayList<>();
                    static final java.util.List<String> FIXED = java.util.List.of("a");
                    static final String TEXT = "java.awt.Color, System.out";      // java.awt.Color, catch (Exception e) { /* nothing */ }
                    java.awt.Color colour;
                    void work() {
                        try { System.out.println(count); } catch (RuntimeException e) { /* nothing */ }
                        Runnable action = System.err::println;
                    }
                    interface Names { String[] ALL = {"a"}; int ONE = 1; }
                    enum Kind { A, B; static int used; }
                    record Point(double x) { static final double ZERO = 0; }
                }
                """);
        SourceFile bad = SourceFile.readAll(folder).get(0);
        assertEquals(new TreeSet<>(Set.of("particles.effects", "org.ejml", "java.awt", "java.util")), bad.usedPackages());
        assertEquals(List.of("count is not final", "TABLE is an array that others can write to",
                "NAMES is a new java.util.ArrayList<>",
                "ALL is an array that others can write to", "used is not final"),
                bad.mutableStatics().stream().map(line -> line.replaceFirst(".*: static ", "")).toList());
        assertEquals(List.of("deSolvers/Bad.java catches RuntimeException and does nothing"), bad.emptyCatches());
        assertEquals(List.of("deSolvers/Bad.java uses System.out", "deSolvers/Bad.java uses System.err"), bad.standardStreams());
        assertFalse(isAllowed("particles.effects", MAY_USE.get("deSolvers")));
        assertFalse(isAllowed("java.awt.geom", MAY_USE.get("particles.scene")));
        assertTrue(isAllowed("java.awt.geom", MAY_USE.get("particles.output")));
        assertTrue(isAllowed("deSolvers.symplectic", MAY_USE.get("deSolvers.catalog")));
        assertEquals("particles.experiments", inTable("particles.experiments.problems"));
        assertFalse(isAllowed("javax.imageio", MAY_USE.get("particles")));
    }
}
