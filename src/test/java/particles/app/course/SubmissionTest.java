package particles.app.course;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static particles.Texts.assertHas;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import particles.OtherSystems;
import particles.spec.messages.InvalidInputException;

/** Of a hand-in, only the student's own files count. */
class SubmissionTest {
    private static final List<String> FILES = List.of("__MACOSX/exercises/._HeunSolver.java", ".git/Other.java",
            "src/test/java/exercises/Other.java", "src/main/java/particles/teaching/exercises/Other.java",
            "exercises/backup/HeunSolver.java", "exercises/HeunSolver.java", "work/answers.yaml", "work/Swing.yml");

    @Test
    void filesOfTheProjectAndOfTheSystemAreLeftOut(@TempDir Path folder) throws Exception {
        Path handIn = folder.resolve("hw1-mary-ann");
        for (String name : FILES) {
            Files.createDirectories(handIn.resolve(name).getParent());
            Files.writeString(handIn.resolve(name), name);
        }
        Submission read = Submission.read("hw1-mary-ann", List.of(handIn));
        assertEquals(Set.copyOf(FILES.subList(4, 8)), read.files().keySet());
        assertEquals(Map.of("HeunSolver", "exercises/HeunSolver.java"), read.sources());
        assertEquals(List.of(List.of(), List.of()), List.of(read.damaged(), read.remarks()));
        for (String path : List.of("Swing.yml", "./swing.yml")) {
            assertEquals("work/Swing.yml", new String(read.file(path), StandardCharsets.UTF_8));
        }
        for (String path : List.of("../exercises/HeunSolver.java", "/etc/passwd", "none.yaml")) {
            assertHas(assertThrows(InvalidInputException.class, () -> read.file(path)).getMessage(), path
                    + ": there is no such file in the hand-in");
        }
    }

    @Test
    void linksAreNotFollowed(@TempDir Path folder) throws Exception {
        Path secret = Files.writeString(folder.resolve("secret.yaml"), "2: 1\n");
        Path root = Files.createDirectories(folder.resolve("in/one"));
        OtherSystems.link(root.resolve("answers.yaml"), secret);
        OtherSystems.link(root.resolve("MySolver.java"), secret);
        OtherSystems.link(folder.resolve("in/two"), root);
        assertEquals(Map.of(), Submission.read("", List.of(root)).files());
        assertEquals(Set.of("one"), Submission.list(folder.resolve("in")).keySet());
    }
}
