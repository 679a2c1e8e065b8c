package browser;

import static org.junit.jupiter.api.Assertions.assertEquals;

import deSolvers.catalog.SolverCatalog;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import particles.lab.Session;
import particles.scene.SceneFiles;
import particles.scene.SceneReader;
import particles.spec.ClassNames;

/**
 * The page and Java compute the same results from the same scene, with every solver. The page has other bits than Java
 * where it rounds twice, for springs' fused multiply-add, and where its sines differ in the last bit.
 */
class SameResultsTest {
    private static final double SECONDS = 2;
    private static final int FEW_STEPS = 4;
    /** Scenes that need only + - * / and square roots, and others that happen to have the same bits. */
    private static final Set<String> SAME_BITS = Set.of("01", "02", "03", "06", "07", "11", "22", "25", "26",
            "40", "41");
    /**
     * Those that have the same bits after a few steps of any solver. Births restart adaptive solvers, whose first
     * sub-steps are powers that the page rounds otherwise: 1.5e-16 in the fountain.
     */
    private static final Set<String> ALWAYS_SAME_BITS = Set.of("01", "02", "03", "06", "07", "13", "21", "22", "26",
            "41", "43");
    /** Of the state's largest number. Measured at most 2.6e-11, in the stiff curtain, 1.6e-11 in the torn cloth. */
    private static final double BOUND = 1e-10;
    /**
     * Of scene 18, where radau's iterations stop at a tolerance of 1e-6. Measured 8.2e-10 after 2 s, and at most 9.0e-9
     * at sixteen times in the 8 s of the scene.
     */
    private static final double BOUND_OF_RADAU = 8e-9;
    /** After a few steps. Measured at most 1.5e-12, radau on the cloth. */
    private static final double BOUND_OF_FEW_STEPS = 1e-11;
    /** Three steps of the stiff curtain and pendulum. Measured at most 7.1e-10, bulirsch-stoer on the curtain. */
    private static final double BOUND_OF_STIFF = 5e-9;
    private static final Set<String> STIFF = Set.of("17", "18");
    private static Browser browser;

    /** A run: the scene's file and text, the solver (empty: the scene's), and until when it goes (s). */
    private record Run(String file, String text, String solver, double time) {
        String number() {
            return Path.of(file).getFileName().toString().substring(0, 2);
        }

        List<Object> list() {
            return List.of(file, text, solver, time);
        }
    }

    /** Makes runs one after the other in a worker of their own: for each, its mistakes or failure, and its bits. */
    private static final String RUNS = """
            const [runs, done] = arguments, found = [];
            const worker = new Worker(window.lab.engine);
            const tell = (words, state) => {
              found.push([words, ...[...new BigUint64Array(state)].map(number => number.toString(16))]);
              found.length < runs.length ? next() : done(found, worker.terminate());
            };
            const next = () => {
              const [file, text, solver, time] = runs[found.length];
              worker.postMessage({type: 'open', run: time, file, text, solver, deltaT: '', tolerance: 0, set: ''});
            };
            worker.onmessage = ({data}) => {
              if (data.type === 'opened' && !data.facts.errors) {
                worker.postMessage({type: 'sample', time: data.run});
              } else if (data.type === 'sample') {
                tell(data.failure, data.lastStep.buffer);
              } else if (data.type === 'opened' || data.type === 'broken') {
                tell(data.facts?.errors.join('\\n') ?? data.message, new ArrayBuffer(0));
              }
            };
            next();
            """;

    @BeforeAll
    static void open() {
        browser = Browser.open(1000, 800);
    }

    @AfterAll
    static void close() {
        browser.close();
    }

    private static List<List<String>> inThePage(List<Run> runs) {
        List<List<String>> found = new ArrayList<>();
        for (Object run : (List<?>) browser.later(RUNS, runs.stream().map(Run::list).toList())) {
            found.add(((List<?>) run).stream().map(String.class::cast).toList());
        }
        return found;
    }

    /** What is wrong with a run in the page; empty if nothing is. */
    private static String difference(Run run, List<String> found, boolean sameBits, double bound) {
        Session session = new Session(ClassNames.none());
        session.open(run.file(), run.text(), run.solver(), "", 0, "");
        session.advance(run.time(), 1e9);
        String failure = session.status().replaceFirst(".*\"failure\":\"(.*)\"}", "$1").replace("\\u000a", "\n");
        if (!failure.isEmpty() || !found.get(0).isEmpty()) {
            return words(failure).equals(words(found.get(0))) ? "" : failure + " / in the page: " + found.get(0);
        }
        double[] expected = session.exactState();
        double[] page = found.stream().skip(1).mapToDouble(bits -> Double.longBitsToDouble(
                Long.parseUnsignedLong(bits, 16))).toArray();
        if (sameBits || page.length != expected.length) {
            return Arrays.equals(expected, page) ? "" : "not the same bits";
        }
        double largest = Arrays.stream(expected).map(Math::abs).max().orElse(0);
        double off = 0;
        for (int i = 0; i < page.length; i++) {
            off = Math.max(off, Math.abs(page[i] - expected[i]));
        }
        return off <= bound * largest ? "" : off / largest + " of the largest number";
    }

    /** A failure without numbers and names: a run that blows up magnifies differences in the last bit. */
    private static String words(String failure) {
        return failure.replaceAll("'[^']*'", "").replaceAll("-?[0-9][0-9.e-]*", "");
    }

    static Stream<Path> scenes() {
        return SceneFiles.list(Path.of("scenes")).stream();
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void twoSecondsOfASceneAreTheSame(Path scene) {
        Run run = new Run(scene.toString(), SceneReader.withFiles(scene, ClassNames.none(), List.of()), "", SECONDS);
        List<String> found = inThePage(List.of(run)).get(0);
        assertEquals("", found.get(0));
        assertEquals("", difference(run, found, SAME_BITS.contains(run.number()),
                run.number().equals("18") ? BOUND_OF_RADAU : BOUND));
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void aFewStepsAreTheSameWithEverySolver(Path scene) {
        String text = SceneReader.withFiles(scene, ClassNames.none(), List.of());
        double time = FEW_STEPS * SceneReader.read(scene).deltaT();
        List<Run> runs = SolverCatalog.names().stream().map(solver -> new Run(scene.toString(), text, solver, time))
                .toList();
        List<List<String>> found = inThePage(runs);
        Map<String, String> wrong = new TreeMap<>();
        for (int i = 0; i < runs.size(); i++) {
            Run run = runs.get(i);
            wrong.put(run.solver(), difference(run, found.get(i), ALWAYS_SAME_BITS.contains(run.number()),
                    STIFF.contains(run.number()) ? BOUND_OF_STIFF : BOUND_OF_FEW_STEPS));
        }
        wrong.values().removeIf(String::isEmpty);
        assertEquals(Map.of(), wrong);
    }

    @ParameterizedTest
    @MethodSource("particles.scene.BrokenScenesTest#brokenScenes")
    void brokenScenesGiveTheSameLines(String text, List<String> lines) {
        Run run = new Run("x.yaml", text, "", 0);
        assertEquals(List.of(String.join("\n", lines)), inThePage(List.of(run)).get(0));
    }
}
