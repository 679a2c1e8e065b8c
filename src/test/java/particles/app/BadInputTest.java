package particles.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.arguments;
import static particles.Texts.assertHas;
import static particles.Texts.assertStarts;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Malicious files, given to the program with half a gigabyte of memory: it ends with one clear line and the right code,
 * and writes nothing. Measured: 0.3 to 0.6 s each, of which 0.25 s is Java's start.
 */
@Tag("slow")
class BadInputTest {
    private static final String HEAD = "title: a\nteaches: b\nsolver: rk4\ndeltaT: 0.01\nduration: 1\n";
    private static final String BOB = "particles:\n  - {id: bob, position: [0, 1, 0]}\n";
    private static final String CLOTH = "shapes:\n  - cloth: {corner: [0, 0, 0], across: [1, 0, 0], down: [0,"
            + " -1, 0], columns: %s,"
            + " rows: %s, totalMass: 1, structural: {stiffness: 1}}\n";
    private static final String EMITTER = HEAD + BOB
            + "rules:\n  - emitter: {id: drop, position: [0, 0, 0], speed: 1, rate: 1e6, mass: 1}\n";

    @TempDir
    Path top;

    /** A name, the file's contents, and what the message must say. */
    static Stream<Arguments> files() {
        StringBuilder bomb = new StringBuilder("a0: &a0 [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]\n");
        for (int i = 1; i < 12; i++) {
            bomb.append("a%d: &a%d [%s]\n".formatted(i, i, ("*a" + (i - 1) + ", ").repeat(9) + "*a" + (i - 1)));
        }
        return Stream.of(
                arguments("bomb", bomb.toString(), "anchors and aliases"),
                arguments("an anchor that holds itself", "a: &a [*a]\n", "anchors and aliases"),
                arguments("merge keys", HEAD + "x: &x {id: bob}\nparticles: [{<<: *x}]\n", "anchors and aliases"),
                arguments("brackets", "[".repeat(90_000), "nested more than 20 deep"),
                arguments("braces", "{a: ".repeat(100_000), "nested more than 20 deep"),
                arguments("dashes", "- ".repeat(100_000), "nested more than 20 deep"),
                arguments("a long word", "a".repeat(1_500_000), "more than 100000 characters without a space"),
                arguments("a long file", " ".repeat(3 << 20), "longer than 2 MiB"),
                arguments("many keys", "k: 1\n".repeat(400_000), ""),
                arguments("a huge number", (HEAD + BOB).replace("0.01", "1" + "0".repeat(90_000)), "'deltaT' is"),
                arguments("a huge exponent", (HEAD + BOB).replace("0.01", "1e999999999"), "'deltaT' is"),
                arguments("a billion particles", HEAD + CLOTH.formatted("31623", "31623"),
                        "1000014129 particles; a scene may have at most 1000000"),
                arguments("more particles than numbers", HEAD + CLOTH.formatted("1000000000", "1000000000"),
                        "a whole number from 2 to 1000000"),
                arguments("a billion births", EMITTER.replace("duration: 1\n", "duration: 1000\n"),
                        "MiB of memory for 1000000001 particles"),
                arguments("a billion births at once", (EMITTER
                        + "  - kill: {point: [0, -1, 0]}\n").replace("deltaT: 0.01", "deltaT: 2000")
                        .replace("duration: 1\n", "duration: 2000\n"), "MiB of memory for 2000000001 particles"),
                arguments("too much for the heap", HEAD.replace("rk4", "radau") + CLOTH.formatted("600", "600"),
                        "of memory for 360000 particles"),
                arguments("half of a surrogate pair", new byte[] {'a', ':', ' ', (byte) 0xed, (byte) 0xa0, (byte) 0x80},
                        "a byte here is not UTF-8"),
                arguments("nothing", "", "the file is empty"),
                arguments("another language", "<?xml version=\"1.0\"?><scene><title>x</title></scene>", ""),
                arguments("a directive", "%YAML 9.9\n---\n" + HEAD, ""),
                arguments("a tag", HEAD + "particles: !!java.net.URL [http://localhost]\n",
                        "tags (!name) are not used"));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("files")
    void isOneClearLine(String name, Object contents, String message) throws Exception {
        Path file = Files.write(top.resolve("scene.yaml"), contents instanceof String text
                ? text.getBytes(StandardCharsets.UTF_8) : (byte[]) contents);
        Path out = top.resolve("out");
        ChildProgram.End end = new ChildProgram(top.resolve("lines.txt")).jvm("-Xmx512m").run("run", "--scene=" + file,
                "--out=" + out);
        assertEquals(2, end.code(), end.lines());
        assertFalse(Files.exists(out), "nothing is written");
        List<String> lines = end.lines().lines().toList();
        assertTrue(lines.size() <= 51, "at most 50 problems and how many more: " + lines.size());
        assertStarts(lines.get(0), file.toString());
        assertHas(end.lines(), message);
        assertTrue(lines.stream().allMatch(line -> line.length() < 1200), "lines that can be read");
        assertFalse(end.lines().contains("Exception") || end.lines().contains("\tat "), end.lines());
    }
}
