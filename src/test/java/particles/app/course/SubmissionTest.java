package particles.app.course;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static particles.Texts.assertHas;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.zip.CRC32;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
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

    private static byte[] zip(String name, byte[] contents) throws Exception {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ZipOutputStream zip = new ZipOutputStream(bytes)) {
            CRC32 sum = new CRC32();
            sum.update(contents);
            ZipEntry entry = new ZipEntry(name);
            entry.setMethod(ZipEntry.STORED);
            entry.setSize(contents.length);
            entry.setCrc(sum.getValue());
            zip.putNextEntry(entry);
            zip.write(contents);
        }
        return bytes.toByteArray();
    }

    private static Submission zipped(Path folder, byte[] bytes) throws Exception {
        return Submission.read("ann", List.of(Files.write(folder.resolve("ann.zip"), bytes)));
    }

    /** Python's zipfile.writestr makes a name with "./". */
    @Test
    void aNameMayBeginWithTheFolderItself(@TempDir Path folder) throws Exception {
        Submission read = zipped(folder, zip("./answers.yaml", "2: 1\n".getBytes(StandardCharsets.UTF_8)));
        assertEquals(List.of(List.of("./answers.yaml"), List.of()), List.of(read.answers(), read.damaged()));
        assertEquals("2: 1\n", new String(read.file("answers.yaml"), StandardCharsets.UTF_8));
    }

    @Test
    void aDamagedTextIsNotTheStudents(@TempDir Path folder) throws Exception {
        byte[] bytes = zip("answers.yaml", "2: 1\n".getBytes(StandardCharsets.UTF_8));
        int digit = new String(bytes, StandardCharsets.ISO_8859_1).indexOf("2: 1");
        bytes[digit] = '3';
        Submission read = zipped(folder, bytes);
        assertEquals(List.of(Map.of(), List.of("answers.yaml: it is damaged")), List.of(read.files(),
                read.damaged()));
    }

    /** One that contains itself would never end. */
    @Test
    void archivesInsideArchivesAreNotOpened(@TempDir Path folder) throws Exception {
        Submission read = zipped(folder, zip("work.zip", zip("answers.yaml", new byte[0])));
        assertEquals(List.of(Map.of(), List.of(), List.of("work.zip"), List.of("work.zip is not read")), List.of(
                read.files(), read.damaged(), read.others(), read.remarks()));
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
