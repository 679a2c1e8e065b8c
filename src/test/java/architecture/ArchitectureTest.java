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
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.io.TempDir;

/**
 * Rules of the architecture, checked on the sources: which package may use which (imports and fully-qualified names),
 * lengths of files and lines, and that only the command line prints.
 */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)         // the sources are read once
class ArchitectureTest {
    private static final Path MAIN = Path.of("src/main/java");
    private static final Path TESTS = Path.of("src/test/java");
    private static final int MOST_CODE_LINES = 240;
    private static final int MOST_FILES = 22;

    /** For each package, what it may use besides itself and the plain JDK. */
    private static final Map<String, Set<String>> MAY_USE = table("""
            deSolvers:
            deSolvers.adaptive:            deSolvers deSolvers.rungeKutta
            deSolvers.catalog:             deSolvers deSolvers.adaptive deSolvers.extrapolation deSolvers.implicit
                                           deSolvers.multistep deSolvers.symplectic deSolvers.text
            deSolvers.extrapolation:       deSolvers deSolvers.adaptive
            deSolvers.implicit:            deSolvers deSolvers.adaptive deSolvers.linear deSolvers.text org.ejml
            deSolvers.linear:              org.ejml
            deSolvers.multistep:           deSolvers
            deSolvers.problems:            deSolvers org.hipparchus
            deSolvers.rungeKutta:          deSolvers
            deSolvers.symplectic:          deSolvers deSolvers.text
            deSolvers.text:
            particles:                     deSolvers deSolvers.text particles.engine particles.law
            particles.app:                 particles.app.cli particles.app.course particles.app.experiments
                                           particles.app.run particles.app.student particles.output.files
                                           particles.output.report
            particles.app.cli:             deSolvers deSolvers.text particles particles.experiments.runs
                                           particles.output.charts particles.output.files particles.spec
                                           particles.spec.messages picocli
            particles.app.course:          particles.app.cli particles.app.student particles.output.charts
                                           particles.output.files particles.output.frames particles.output.report
                                           particles.spec particles.spec.messages particles.teaching
                                           particles.teaching.exercises particles.view com.google.gson
                                           org.apache.commons picocli
            particles.app.experiments:     deSolvers.catalog deSolvers.text particles.app.cli
                                           particles.app.run particles.app.student particles.experiments.energy
                                           particles.experiments.grid particles.experiments.lecture
                                           particles.experiments.phase particles.experiments.race
                                           particles.experiments.runs particles.experiments.stability
                                           particles.experiments.work particles.law particles.output.animation
                                           particles.output.charts particles.output.files particles.output.frames
                                           particles.output.report particles.scene particles.scene.format particles.spec
                                           particles.spec.messages particles.view org.apache.commons picocli
            particles.app.run:             deSolvers.catalog deSolvers.text particles particles.app.cli
                                           particles.app.student particles.energy particles.engine
                                           particles.experiments.phase particles.experiments.runs particles.lab
                                           particles.law particles.output.animation particles.output.charts
                                           particles.output.files particles.output.frames particles.output.report
                                           particles.output.usd particles.scene particles.scene.format particles.spec
                                           particles.spec.messages particles.view picocli
            particles.app.student:         deSolvers deSolvers.catalog particles particles.app.cli
                                           particles.effects.springs particles.law
                                           particles.output.charts particles.output.files particles.output.report
                                           particles.spec particles.spec.messages particles.teaching
                                           particles.teaching.declared particles.teaching.effects
                                           particles.teaching.exercises particles.teaching.figures
                                           particles.teaching.solvers particles.view
                                           javax.tools picocli
            particles.effects:             deSolvers particles.effects.neighbours particles.effects.springs
                                           particles.law particles.spec particles.spec.messages
            particles.effects.neighbours:  particles.law
            particles.effects.springs:     deSolvers particles.law particles.view
            particles.energy:              deSolvers.text particles particles.law particles.view
            particles.engine:              deSolvers particles.law
            particles.experiments.energy:  deSolvers.text particles particles.energy particles.experiments.runs
                                           particles.scene particles.scene.format particles.view
            particles.experiments.grid:    deSolvers.catalog deSolvers.text particles particles.energy
                                           particles.experiments.runs particles.experiments.stability particles.law
                                           particles.scene particles.scene.format particles.spec
                                           particles.spec.messages particles.view
            particles.experiments.lecture: deSolvers deSolvers.catalog deSolvers.problems particles.view
                                           org.hipparchus
            particles.experiments.phase:   deSolvers.text particles particles.experiments.runs particles.law
                                           particles.scene.format particles.view
            particles.experiments.race:    deSolvers.text particles particles.energy particles.experiments.energy
                                           particles.experiments.runs particles.law particles.scene
                                           particles.scene.format particles.view
            particles.experiments.runs:    deSolvers deSolvers.catalog particles particles.law particles.scene
                                           particles.scene.format particles.view
            particles.experiments.stability: deSolvers deSolvers.catalog deSolvers.implicit deSolvers.linear
                                           deSolvers.problems deSolvers.text particles particles.experiments.runs
                                           particles.law particles.scene.format particles.view org.ejml
                                           org.hipparchus
            particles.experiments.work:    deSolvers deSolvers.catalog deSolvers.implicit deSolvers.problems
                                           deSolvers.text particles particles.experiments.runs
                                           particles.experiments.stability particles.law particles.scene particles.view
            particles.lab:                 deSolvers deSolvers.catalog deSolvers.text particles particles.effects
                                           particles.effects.springs particles.energy particles.experiments.stability
                                           particles.law particles.scene particles.scene.format particles.spec
                                           particles.spec.messages particles.view org.teavm
            particles.lab.browser:         deSolvers particles.effects particles.lab particles.scene particles.spec
                                           org.teavm
            particles.lab.compile:         deSolvers.catalog particles.effects particles.effects.springs particles.lab
                                           particles.spec org.teavm
            particles.law:                 deSolvers
            particles.output.animation:    particles particles.output.charts particles.output.files
                                           particles.output.frames particles.view java.awt javax.imageio org.jcodec
            particles.output.charts:       deSolvers.text particles.output.files particles.view java.awt
                                           javax.imageio javax.xml com.lowagie org.apache.batik org.jfree org.w3c.dom
            particles.output.files:        particles particles.law java.awt ar.com.hjg.pngj com.fasterxml.jackson
            particles.output.frames:       deSolvers.text particles particles.law particles.output.files
                                           particles.output.painters particles.output.raster particles.view java.awt
            particles.output.painters:     particles particles.law particles.output.raster particles.view
                                           com.carrotsearch.hppc
            particles.output.raster:       deSolvers.text particles.law particles.view java.awt
            particles.output.report:       deSolvers.catalog deSolvers.text particles.output.charts
                                           particles.output.files particles.view javax.imageio com.samskivert
            particles.output.usd:          particles.law particles.output.files particles.output.frames
                                           particles.output.painters particles.output.raster particles.view
            particles.reactions:           deSolvers deSolvers.linear deSolvers.text particles particles.law
                                           particles.view
            particles.rules:               deSolvers.text particles particles.effects.neighbours
                                           particles.effects.springs particles.law particles.reactions particles.view
            particles.scene:               deSolvers deSolvers.catalog deSolvers.text particles particles.effects
                                           particles.effects.springs particles.law particles.reactions particles.rules
                                           particles.scene.format particles.scene.parts particles.spec
                                           particles.spec.messages particles.view org.snakeyaml
            particles.scene.format:        deSolvers deSolvers.adaptive deSolvers.catalog particles.effects
                                           particles.law particles.scene.parts particles.spec particles.spec.messages
                                           particles.view
            particles.scene.parts:         particles particles.effects particles.effects.springs particles.law
                                           particles.reactions particles.rules particles.spec particles.spec.messages
                                           particles.view
            particles.spec:                deSolvers.text particles.law particles.spec.messages org.snakeyaml
            particles.spec.messages:       deSolvers.text org.snakeyaml
            particles.teaching:
            particles.teaching.compared:   deSolvers particles.teaching particles.teaching.declared
                                           particles.teaching.sources
            particles.teaching.declared:   deSolvers particles.teaching
            particles.teaching.effects:    deSolvers deSolvers.text particles particles.effects
                                           particles.effects.springs particles.law particles.spec particles.teaching
            particles.teaching.exercises:  deSolvers deSolvers.catalog deSolvers.problems deSolvers.rungeKutta
                                           particles particles.energy particles.experiments.runs particles.law
                                           particles.scene particles.scene.format particles.spec particles.spec.messages
            particles.teaching.figures:    deSolvers deSolvers.catalog deSolvers.problems deSolvers.text
                                           particles.experiments.stability particles.teaching
                                           particles.teaching.solvers particles.teaching.sources particles.view
            particles.teaching.measured:   deSolvers deSolvers.problems particles.teaching
                                           particles.teaching.declared particles.teaching.sources
            particles.teaching.solvers:    deSolvers particles.teaching particles.teaching.compared
                                           particles.teaching.declared particles.teaching.measured
            particles.teaching.sources:    deSolvers deSolvers.problems deSolvers.text particles.teaching
            particles.view:                deSolvers.catalog deSolvers.text particles.law
            """);

    private static Map<String, Set<String>> table(String rows) {
        Map<String, Set<String>> table = new TreeMap<>();
        String room = "";
        for (String word : rows.split("\\s+")) {
            if (word.endsWith(":")) {
                room = word.substring(0, word.length() - 1);
                table.put(room, new TreeSet<>());
            } else {
                table.get(room).add(word);
            }
        }
        return table;
    }

    private final List<SourceFile> sources = SourceFile.readAll(MAIN).stream()
            .filter(source -> !source.packageName().equals("exercises")).toList();

    @Test
    void everyPackageUsesOnlyWhatItsRowAllows() {
        List<String> wrong = new ArrayList<>();
        for (SourceFile source : sources) {
            Set<String> allowed = MAY_USE.get(source.packageName());
            if (allowed == null) {
                wrong.add(source + ": the package is not in the table");
                continue;
            }
            for (String used : source.usedPackages()) {
                if (!used.equals(source.packageName()) && !isAllowed(used, allowed)) {
                    wrong.add(source + " uses " + used);
                }
            }
        }
        assertNone(wrong);
    }

    @Test
    void everyEntryOfTheTableIsUsed() {
        List<String> stale = new ArrayList<>();
        MAY_USE.forEach((room, allowed) -> {
            Set<String> used = new TreeSet<>();
            sources.stream().filter(source -> source.packageName().equals(room))
                    .forEach(source -> used.addAll(source.usedPackages()));
            allowed.stream().filter(name -> used.stream().noneMatch(each -> isOurs(name) ? each.equals(name)
                    : isIn(each, name))).forEach(name -> stale.add(room + " does not use " + name));
        });
        assertNone(stale);
    }

    private static boolean isAllowed(String used, Set<String> allowed) {
        if (isOurs(used)) {
            return allowed.contains(used);
        }
        boolean plainJdk = used.startsWith("java.") && !isIn(used, "java.awt");
        return plainJdk || allowed.stream().anyMatch(name -> !isOurs(name) && isIn(used, name));
    }

    private static boolean isOurs(String used) {
        return isIn(used, "deSolvers") || isIn(used, "particles") || isIn(used, "exercises");
    }

    private static boolean isIn(String used, String parent) {
        return used.equals(parent) || used.startsWith(parent + ".");
    }

    /** Packages use what the table has. Removes those that use none of the remaining ones; a cycle remains. */
    @Test
    void packagesUseEachOtherWithoutCycles() {
        Map<String, Set<String>> left = new TreeMap<>(MAY_USE);
        while (left.entrySet().removeIf(entry -> entry.getValue().stream().noneMatch(left::containsKey))) {
            assertTrue(left.size() < MAY_USE.size());
        }
        assertEquals(Map.of(), left);
    }

    @Test
    void noFileHasMoreThan240CodeLines() {
        assertNone(sources.stream().filter(source -> source.codeLines() > MOST_CODE_LINES)
                .map(source -> source + " has " + source.codeLines() + " lines of code").toList());
    }

    @Test
    void noLineIsWiderThan120Columns() {
        List<SourceFile> all = new ArrayList<>(sources);
        all.addAll(SourceFile.readAll(TESTS));
        assertNone(all.stream().filter(source -> !source.wideLines().isEmpty())
                .map(source -> source + ": lines " + source.wideLines()).toList());
    }

    @Test
    void noPackageHasTooManyFiles() {
        Map<String, Long> files = sources.stream().collect(Collectors.groupingBy(SourceFile::packageName,
                Collectors.counting()));
        assertNone(files.entrySet().stream().filter(room -> room.getValue() > MOST_FILES)
                .map(room -> room.getKey() + " has " + room.getValue() + " files").toList());
    }

    @Test
    void onlyTheCommandLinePrintsAndExits() {
        assertNone(findings(SourceFile::standardStreams,
                source -> !isIn(source.packageName(), "particles.app")));
    }

    @Test
    void noExceptionIsSwallowed() {
        assertNone(findings(SourceFile::emptyCatches, source -> true));
    }

    @Test
    void noStaticIsMutable() {
        assertNone(findings(SourceFile::mutableStatics, source -> true));
    }

    /** Records have bare names; {@code size()} and {@code count()} are those of collections. */
    @Test
    void accessorsOfClassesAreCalledGet() {
        assertNone(findings(SourceFile::bareAccessors, source -> !isIn(source.packageName(), "particles.teaching")));
    }

    private List<String> findings(Function<SourceFile, List<String>> of, Function<SourceFile, Boolean> where) {
        return sources.stream().filter(where::apply).flatMap(source -> of.apply(source).stream()).toList();
    }

    private static void assertNone(List<String> wrong) {
        assertTrue(wrong.isEmpty(), () -> String.join(System.lineSeparator(), wrong));
    }

    /** Tests this test: violations are found, and nothing else. */
    @Test
    void violationsAreFound(@TempDir Path folder) throws IOException {
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
                    // java.awt.Color, catch (Exception e) { /* nothing */ }
                    static final String TEXT = "java.awt.Color, System.out";
                    java.awt.Color colour;
                    void work() {
                        try { System.out.println(count); } catch (RuntimeException e) { /* nothing */ }
                        Runnable action = System.err::println;
                    }
                    interface Names { String[] ALL = {"a"}; int ONE = 1; }
                    enum Kind { A, B; static int used; }
                    record Point(double x) { static final double ZERO = 0; }
                    private double x;
                    double x() { return x; }
                    double getX() { return x; }
                    @Override int y() { return count; }
                    boolean none() { return false; }
                }
                """);
        SourceFile bad = SourceFile.readAll(folder).get(0);
        assertEquals(new TreeSet<>(Set.of("particles.effects", "org.ejml", "java.awt", "java.util")),
                bad.usedPackages());
        assertEquals(List.of("count is not final", "TABLE is an array that others can write to",
                "NAMES is a new java.util.ArrayList<>",
                "ALL is an array that others can write to", "used is not final"),
                bad.mutableStatics().stream().map(line -> line.replaceFirst(".*: static ", "")).toList());
        assertEquals(List.of("deSolvers/Bad.java catches RuntimeException and does nothing"), bad.emptyCatches());
        assertEquals(List.of("deSolvers/Bad.java: x"), bad.bareAccessors());
        assertEquals(List.of("deSolvers/Bad.java uses System.out", "deSolvers/Bad.java uses System.err"),
                bad.standardStreams());
        assertFalse(isAllowed("particles.effects", MAY_USE.get("deSolvers")));
        assertFalse(isAllowed("java.awt.geom", MAY_USE.get("particles.scene")));
        assertTrue(isAllowed("java.awt.geom", MAY_USE.get("particles.output.charts")));
        assertTrue(isAllowed("deSolvers.symplectic", MAY_USE.get("deSolvers.catalog")));
        assertFalse(isAllowed("particles.output.files", Set.of("particles.output")));
        assertFalse(isAllowed("javax.imageio", MAY_USE.get("particles")));
        assertEquals(2, SourceFile.codeLines("int a; // one\n\n/* two\n three */\nString b = \"/* four */\";\n"));
        assertEquals(List.of(2), SourceFile.wideLines("short\n" + "x".repeat(121) + "\n" + "y".repeat(120)));
    }
}
