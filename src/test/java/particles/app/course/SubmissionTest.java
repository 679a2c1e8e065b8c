package particles.app.course;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Of a hand-in, only the student's own files count. */
class SubmissionTest {
    private static final List<String> FILES = List.of("__MACOSX/exercises/._HeunSolver.java", ".git/Other.java",
            "src/test/java/exercises/Other.java", "src/main/java/particles/teaching/exercises/Other.java",
            "exercises/backup/HeunSolver.java", "exercises/HeunSolver.java", "answers.yaml", "swing.yml");

    @Test
    void filesOfTheProjectAndOfTheSystemAreLeftOut(@TempDir Path folder) throws Exception {
        Path handIn = folder.resolve("hw1-mary-ann");
        for (String name : FILES) {
            Files.createDirectories(handIn.resolve(name).getParent());
            Files.writeString(handIn.resolve(name), name);
        }
        Submission read = Submission.read(handIn);
        assertEquals(Set.copyOf(FILES.subList(4, 8)), read.files().keySet());
        assertEquals(Map.of("HeunSolver", "exercises/HeunSolver.java"), read.sources());
        assertEquals(List.of(), read.problems());
        read.copyAnswers(folder.resolve("copy"));
        assertEquals("swing.yml", Files.readString(folder.resolve("copy/swing.yml")));
        assertEquals(List.of(0, 3, 8), List.of(read.longestOf(List.of("bob", "")), read.longestOf(List.of("ann")),
                read.longestOf(List.of("ann", "mary-ann"))));
    }

    @Test
    void filesThatAreTooManyAreTold(@TempDir Path folder) throws Exception {
        for (int n = 0; n < 1002; n++) {
            Files.createFile(folder.resolve("scene" + n + ".yaml"));
        }
        assertEquals(List.of("there are more than 1000 YAML and Java files; the others were not read"),
                Submission.read(folder).problems());
    }

    /** As a name with an umlaut in a zip is where the locale is C. */
    @Test
    void aFileThatCannotHaveItsNameHereIsTold(@TempDir Path folder) throws Exception {
        Submission read = new Submission("bob", Map.of("a\0.yaml", new byte[0], "answers.yaml", new byte[0],
                "A\0.java", new byte[0]), Instant.EPOCH);
        assertEquals(List.of("no file of this machine can have the name a\0.yaml"), read.problems());
        read.copyAnswers(folder);
        assertEquals(Set.of("answers.yaml"), Set.of(folder.toFile().list()));
    }
}
