package particles.scene;

import static deSolvers.problems.Bounds.assertBelow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Texts.assertStarts;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import particles.scene.format.SceneFormat;
import particles.scene.parts.ParticleDescription;
import particles.spec.messages.InvalidInputException;

/** Reading any file ends quickly with a scene or with clear lines. */
class SturdyReaderTest {
    private static final String GOOD = """
            title: Good
            teaches: nothing
            solver: rk4
            deltaT: 1e-2
            duration: 1
            particles:
              - {id: bob, position: [0, 1, 0]}
            """;

    private static List<String> linesFor(byte[] bytes) {
        return assertThrows(InvalidInputException.class, () -> SceneReader.read("x.yaml", bytes)).getLines();
    }

    private static List<String> linesFor(String text) {
        return linesFor(text.getBytes(StandardCharsets.UTF_8));
    }

    private static ParticleDescription particle(String text) {
        return TestScenes.read(text).particles().getParticles().get(0);
    }

    @Test
    void lineEndsAndByteOrderMarkMakeNoDifference() {
        assertEquals(0.01, TestScenes.read(GOOD).deltaT());
        for (String same : List.of(GOOD.replace("\n", "\r\n"), "\uFEFF" + GOOD, GOOD.strip(),
                "\n# comment\n\n" + GOOD)) {
            assertEquals(particle(GOOD).position(), particle(same).position());
        }
        assertEquals(List.of("x.yaml:8:1: unknown key 'x'; known in the scene: " + String.join(", ",
                SceneFormat.SCENE.getKeys().stream().map(key -> key.name()).toList())),
                linesFor(GOOD.replace("\n", "\r\n") + "x: 1\r\n"));
    }

    @Test
    void otherEncodingsAreRefusedByName() {
        assertEquals(List.of("x.yaml: the file is in UTF-16; save it as UTF-8"),
                linesFor(GOOD.getBytes(StandardCharsets.UTF_16)));
        assertEquals(List.of("x.yaml:2:11: a byte here is not UTF-8; save the file as UTF-8"),
                linesFor("title: Good\nteaches: f\u00fcr\n".getBytes(StandardCharsets.ISO_8859_1)));
        assertEquals(List.of("x.yaml:1:8: a character here is not printable: a zero byte; is this a text file?"),
                linesFor("title: \0"));
        assertEquals(List.of("x.yaml:2:3: a character here is not printable: U+0007"), linesFor("a: 1\nb:\u0007"));
        assertEquals(List.of("x.yaml:2:4: a character here is not printable: U+007F"), linesFor("a: 1\nb: \u007f"));
    }

    @Test
    void idsMayHaveLettersOfAnyLanguage() {
        assertEquals("k\u016bmara", particle(GOOD.replace("bob", "k\u016bmara")).id());
    }

    @Test
    void depthSizeAndNumbersHaveLimits() {
        assertEquals(List.of("x.yaml:1:21: nested more than 20 deep"), linesFor("[".repeat(100_000)));
        assertEquals(List.of("x.yaml:1:50: nested more than 20 deep"), linesFor("a: " + "{a: ".repeat(9)
                + "[".repeat(100_000)));
        assertEquals(List.of("x.yaml: the file is longer than 2 MiB; use shapes to make many particles"),
                linesFor(new byte[3 << 20]));
        List<String> lines = linesFor("particles:\n" + "- 1\n".repeat(250_000));
        assertEquals(List.of("x.yaml:199999:3: more than 200000 values; use shapes to make many particles"), lines);
    }

    @Test
    void hugeNumbersAreRefused() {
        for (String number : List.of("1e31", "-1e999", ".inf", "-.inf", "9".repeat(400), "0x" + "f".repeat(40))) {
            List<String> lines = linesFor(GOOD.replace("[0, 1, 0]", "[0, " + number + ", 0]"));
            assertEquals(1, lines.size());
            assertStarts(lines.get(0), "x.yaml:7:29: y of 'position' is ");
            assertTrue(lines.get(0).endsWith("; numbers in a scene are at most 1e30"), lines.get(0));
        }
        assertEquals(List.of("x.yaml:7:29: y of 'position' is .nan; it has to be a number (m)"),
                linesFor(GOOD.replace("[0, 1, 0]", "[0, .nan, 0]")));
        assertEquals(16, particle(GOOD.replace("[0, 1, 0]", "[0, 0x10, 0]")).position().y());
    }

    @Test
    void everyMessageIsOneShortLine() {
        for (String text : List.of("\"a\\nb\\u2028c\\x07\": 1\n", "solver: \"" + "x".repeat(100_000) + "\"\n",
                "x".repeat(100_000) + ": 1\n")) {
            for (String line : linesFor(text)) {
                assertFalse(line.matches("(?s).*[\\p{Cntrl}\\u2028\\u2029].*"), line);
                assertBelow(1100, line.length());
            }
        }
    }

    @Test
    void aMissingFileIsOneLine(@TempDir Path folder) {
        String missing = folder.resolve("no.yaml").toString();
        assertEquals(List.of(missing + ": there is no such file"),
                assertThrows(InvalidInputException.class, () -> SceneReader.read(Path.of(missing))).getLines());
        assertEquals(List.of(folder + ": this is a folder; it has to be a file"),
                assertThrows(InvalidInputException.class, () -> SceneReader.read(folder)).getLines());
    }
}
