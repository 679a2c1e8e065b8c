package particles.app.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Systems.onMove;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.Simulation;
import particles.scene.SceneBuilder;
import particles.scene.TestScenes;
import particles.scene.format.SceneDescription;

/** The lines on a run's time, with a fake clock. */
class ProgressTest {
    private final StringWriter out = new StringWriter();
    private SceneDescription scene = scene("");

    private static SceneDescription scene(String more) {
        SceneDescription scene = TestScenes.read("""
                title: a
                teaches: b
                solver: euler
                deltaT: 0.5
                duration: 50
                particles: [{id: bob, position: [0, 1, 0], fixed: true}]
                """ + more);
        return more.startsWith("output") ? scene : scene.withOutput(scene.output().with(false, false));
    }

    /** Runs 100 steps in the given time on the clock. */
    private List<String> linesOf(double seconds) {
        return linesOf(seconds, seconds / 100);
    }

    /** @param first the time of the first of 100 steps (s), whose others take the same time as before */
    private List<String> linesOf(double seconds, double first) {
        return linesOf(time -> time == 0 ? first : seconds / 100);
    }

    /** @param ofStep the time of the step that begins at this simulated time (s) */
    private List<String> linesOf(DoubleUnaryOperator ofStep) {
        AtomicLong nanos = new AtomicLong(123);
        Simulation simulation = SceneBuilder.build(scene).simulation();
        simulation.addObserver(onMove(motion -> {
            double part = (motion.getEndTime() - motion.getStartTime()) / 0.5;      // births divide a step
            nanos.addAndGet((long) (part * ofStep.applyAsDouble(motion.getStartTime()) * 1e9));
        }));
        simulation.addObserver(new Progress(new PrintWriter(out), scene, nanos::get));
        simulation.run();
        return out.toString().lines().toList();
    }

    @Test
    void aShortRunIsSilent() {
        assertEquals(List.of(), linesOf(1.9));
    }

    @Test
    void aRunOfAFewSecondsIsNotAnnounced() {
        assertEquals("t = 12.5 s of 50 s, 25 %, about 6 s to go", linesOf(8).get(0));
    }

    @Test
    void aLongRunPrintsItsProgress() {
        List<String> lines = linesOf(20);
        assertEquals(List.of("this takes about 20 s: 100 steps of 1 particle",
                "t = 5 s of 50 s, 10 %, about 18 s to go", "t = 10 s of 50 s, 20 %, about 16 s to go"),
                lines.subList(0, 3));
        assertTrue(lines.size() >= 9 && lines.size() <= 11, lines.toString());
    }

    @Test
    void aVeryLongRunPrintsEveryTenSeconds() {
        assertEquals(99, linesOf(1100).size());         // nothing is said after the first step, and after the last
    }

    @Test
    void picturesAndBirthsAreCounted() {
        scene = scene("output: {frameRate: 5.01}\nrules: [emitter: {id: jet, position: [0, 0, 0], speed: 1, rate: 4}]");
        assertEquals("this takes about 40 s: 100 steps of up to 201 particles and 251 pictures", linesOf(20).get(0));
    }

    /** The first step also loads classes and makes tables. */
    @Test
    void theFirstStepIsNotTheMeasureOfTheOthers() {
        assertEquals("this takes about 13 s: 100 steps of 1 particle", linesOf(10, 3).get(0));
    }

    /** 20 steps of 2 s, 80 of 0.5 s. At 74 % it takes 13 s more; at the pace of the whole run so far, 23 s. */
    @Test
    void slowStepsAtTheBeginningAreForgotten() {
        List<String> lines = linesOf(time -> time < 10 ? 2 : 0.5);
        assertTrue(lines.contains("t = 37 s of 50 s, 74 %, about 16 s to go"), lines.toString());
    }

    /** The first step takes 3 s, others no time; another run fails in its first step. */
    @Test
    @Tag("slow")
    void aLongFirstStepIsToldOnceAndNotAfterTheRun() throws Exception {
        StringWriter failed = new StringWriter();
        Simulation simulation = SceneBuilder.build(scene).simulation();
        try (Progress ended = new Progress(new PrintWriter(failed), scene, System::nanoTime)) {
            ended.started(simulation.getSystem());
        }
        Progress progress = new Progress(new PrintWriter(out), scene, System::nanoTime);
        simulation.addObserver(progress);
        simulation.start();
        Thread.sleep(3000);
        simulation.advance();
        simulation.advance();
        assertEquals("the first step takes over 2 s: 100 steps of 1 particle", out.toString().strip());
        assertEquals("", failed.toString());
    }

    @ParameterizedTest
    @CsvSource(textBlock = """
            42.1, 43 s
            343,  6 min
            1e4,  3 h
            1e6,  12 days
            """)
    void timesAreInTheUnitThatSuits(double seconds, String text) {
        assertEquals(text, Progress.time(seconds));
    }
}
