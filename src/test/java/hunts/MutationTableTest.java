package hunts;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Counting of mutants, and options of the task. */
class MutationTableTest {
    private static final List<String> CSV = List.of(
            "A.java,deSolvers.A,org.Math,stepState,12,KILLED,deSolvers.ATest",
            "A.java,deSolvers.A$Inner,org.Math,stepState,13,SURVIVED,none",
            "A.java,deSolvers.A,org.Math,stepState,14,TIMED_OUT,none",
            "A.java,deSolvers.A,org.Math,stepState,14,NO_COVERAGE,none",
            "B.java,deSolvers.B,org.Math,stepState,7,MEMORY_ERROR,none");

    @Test
    void everyMutantIsCountedOnceWithItsClass() {
        MutationTable table = MutationTable.ofClasses(CSV);
        assertEquals(new MutationTable.Count(5, 3, 1), table.total());
        assertEquals(60, table.total().percent(), 1e-12);
        assertEquals(String.format("""
                class  mutants  killed  timed out      %%
                A            4       2          1   50.0
                B            1       1          0  100.0
                all          5       3          1   60.0
                """), table.print("class").replace(System.lineSeparator(), "\n"));
        assertEquals(List.of("A"), table.below(85));
        assertEquals(List.of(), table.below(50));
        assertThrows(IllegalArgumentException.class, () -> MutationTable.ofClasses(List.of("nothing")));
    }

    @Test
    void optionsThatDoNotExistAreRefused() {
        assertEquals(List.of("deSolvers.adaptive"),
                MutationTests.packages(new String[] {"--package=deSolvers.adaptive"}));
        assertTrue(message("--pakage=deSolvers")
                .startsWith("unknown option -Ppakage; did you mean -Ppackage? allowed: -Ppackage"));
        assertTrue(message("--package=deSolvers.adaptiv")
                .startsWith("unknown package 'deSolvers.adaptiv'; did you mean 'deSolvers.adaptive'?"));
        assertTrue(message("--package=").startsWith("unknown package ''; allowed: deSolvers, "));
        assertEquals("option -Ppackage needs a value: -Ppackage=...", message("--package"));
    }

    private static String message(String option) {
        return assertThrows(IllegalArgumentException.class,
                () -> MutationTests.packages(new String[] {option})).getMessage();
    }

    /** Every package of solvers is mutated, except the reference problems, which belong to the tests. */
    @Test
    void everyPackageOfSolversAndEffectsIsMutated() throws IOException {
        Path sources = Path.of("src", "main", "java");
        Set<String> found = new TreeSet<>(Set.of("particles.effects"));
        try (Stream<Path> files = Files.walk(sources.resolve("deSolvers"))) {
            found.addAll(files.filter(Files::isDirectory).map(folder -> sources.relativize(folder).toString()
                    .replaceAll("[/\\\\]", "."))
                    .collect(Collectors.toSet()));
        }
        found.remove("deSolvers.problems");
        assertEquals(List.copyOf(found), MutationTests.packages(new String[0]));
    }
}
