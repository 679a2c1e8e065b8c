package browser;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import particles.lab.Session;
import particles.scene.SceneException;
import particles.scene.SceneFiles;
import particles.scene.SceneReader;
import particles.spec.ClassNames;

/** The page and Java compute the same results from the same scene. */
class SameResultsTest {
    private static final double SECONDS = 2;
    /** Scenes that need only + - * / and square roots, and others that happen to have the same bits. */
    private static final Set<String> SAME_BITS = Set.of("01", "02", "03", "06", "07", "11", "22", "25", "26",
            "40", "41");
    /**
     * Of the largest number of the state. Springs use Java's fused multiply-add, which rounds once where a page rounds
     * twice, and sines differ in the last bit. Measured at most 2.6e-11, in the stiff curtain, and 1.6e-11 in the torn
     * cloth.
     */
    private static final double BOUND = 1e-10;
    /**
     * Of scene 18, where radau's iterations stop at a tolerance of 1e-6. Measured 8.2e-10 after 2 s, and at most 9.0e-9
     * at sixteen times in the 8 s of the scene.
     */
    private static final double BOUND_OF_RADAU = 8e-9;
    private static Browser browser;

    /** Runs a scene in a worker of its own. */
    private static final String RUN = """
            const done = arguments[arguments.length - 1];
            const url = URL.createObjectURL(new Blob([document.getElementById('engine').textContent]));
            const worker = new Worker(url);
            worker.onmessage = ({data}) => {
              if (data.type === 'opened' && data.facts.errors) {
                worker.terminate();
                done(data.facts.errors.join('\\n'));
              } else if (data.type === 'state') {
                worker.terminate();
                const bits = [...new BigUint64Array(data.state.buffer)].map(number => number.toString(16));
                done(data.failure + '|' + bits.join(' '));
              }
            };
            worker.postMessage({type: 'open', run: 0, file: arguments[0], text: arguments[1], solver: '', deltaT: 0,
              tolerance: 0});
            worker.postMessage({type: 'state', time: arguments[2]});
            """;

    @BeforeAll
    static void open() {
        browser = Browser.open(1000, 800);
    }

    @AfterAll
    static void close() {
        browser.close();
    }

    static Stream<Path> scenes() {
        return SceneFiles.list(Path.of("scenes")).stream();
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void twoSecondsOfASceneAreTheSame(Path scene) throws IOException {
        String text = Files.readString(scene);
        String[] found = ((String) browser.later(RUN, scene.toString(), text, SECONDS)).split("\\|", -1);
        double[] page = Stream.of(found[1].split(" ")).mapToDouble(bits -> Double.longBitsToDouble(
                Long.parseUnsignedLong(bits, 16))).toArray();
        Session session = new Session(ClassNames.none());
        session.open(scene.toString(), text, "", 0, 0);
        session.advance(SECONDS, 1e9);
        double[] expected = session.exactState();
        assertEquals("", found[0]);
        assertEquals(expected.length, page.length);
        if (SAME_BITS.contains(scene.getFileName().toString().substring(0, 2))) {
            assertArrayEquals(expected, page);
            return;
        }
        double largest = Arrays.stream(expected).map(Math::abs).max().orElse(0);
        boolean radau = scene.getFileName().toString().startsWith("18");
        assertArrayEquals(expected, page, (radau ? BOUND_OF_RADAU : BOUND) * largest);
    }

    @ParameterizedTest
    @MethodSource("particles.scene.BrokenScenesTest#brokenScenes")
    void brokenScenesGiveTheSameLines(String text, List<String> lines) {
        assertEquals(String.join("\n", lines), browser.later(RUN, "x.yaml", text, 0));
    }
}
