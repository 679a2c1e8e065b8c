package particles.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import particles.OtherSystems;

/**
 * The program is killed at a random moment, 12 times, by SIGTERM and by SIGKILL. Every file in the folder is whole
 * each time, and a later run into the same folder leaves exactly what a run into a new folder does.
 */
@Tag("slow")
class KilledRunsTest {
    private static final int KILLS = 12;
    private static final double DURATION = 1;
    private static final int STOPPED_BY_SIGTERM = 143;
    private static final int STOPPED_BY_SIGKILL = 137;

    @TempDir
    Path top;

    @Test
    void killedRunsLeaveWholeFilesAndDoNotAffectTheNextRun() throws Exception {
        OtherSystems.assumeSignals();
        long seed = Long.getLong("desolver.seed", System.nanoTime());
        System.out.println("KilledRunsTest: -Ddesolver.seed=" + seed);
        Random random = new Random(seed);
        Path scene = FaultScene.write(top.resolve("scene.yaml"), DURATION);
        Path whole = top.resolve("whole");
        long begin = System.nanoTime();
        assertEquals(0, child().run("run", "--scene=" + scene, "--out=" + whole).code());
        int millis = (int) TimeUnit.NANOSECONDS.toMillis(System.nanoTime() - begin);
        Map<String, String> expected = WholeFiles.sums(whole);

        int begun = 0;
        int finished = 0;
        Path out = top.resolve("out");
        for (int kill = 0; kill < KILLS;) {
            String moment = "seed " + seed + ", kill " + kill;
            ChildProgram child = child();
            Process process = child.start("run", "--scene=" + scene, "--out=" + out);
            boolean ended = process.waitFor(random.nextInt(millis + millis / 10), TimeUnit.MILLISECONDS);
            if (!ended) {
                kill++;
                kill(process, random.nextBoolean(), moment, child);
                begun += Files.exists(out.resolve("frames/frame-00000.png")) ? 1 : 0;
            } else {
                assertEquals(0, process.exitValue(), moment + ": " + child.lines());
                assertEquals(expected, WholeFiles.sums(out), moment);
                finished++;
            }
            WholeFiles.assertWhole(out);
        }
        ChildProgram.End end = child().run("run", "--scene=" + scene, "--out=" + out);
        assertEquals(0, end.code(), end.lines());
        assertEquals(expected, WholeFiles.sums(out), "seed " + seed);
        assertTrue(begun >= KILLS / 5, "only " + begun + " of " + KILLS + " had begun to write");
        System.out.println("KilledRunsTest: killed while writing: " + begun + ", ran to the end: " + finished);
    }

    private void kill(Process process, boolean gently, String moment, ChildProgram child) throws Exception {
        if (gently) {
            process.destroy();
        } else {
            process.destroyForcibly();
        }
        ChildProgram.End end = child.end(process);
        assertTrue(end.code() == 0 || end.code() == (gently ? STOPPED_BY_SIGTERM : STOPPED_BY_SIGKILL),
                moment + ": exit code " + end.code() + "\n" + end.lines());
    }

    private ChildProgram child() throws IOException {
        return new ChildProgram(top.resolve("lines.txt"));
    }
}
