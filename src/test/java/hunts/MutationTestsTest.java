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

/** Options of the task. */
class MutationTestsTest {
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
