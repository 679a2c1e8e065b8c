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

/**
 * The program killed at any moment, fifty times, by SIGTERM and by SIGKILL: what is in the folder is whole each time, and
 * the run that is continued again and again leaves in the end what an unbroken one does.
 */
@Tag("slow")
class KilledRunsTest {
    private static final int KILLS = 50;
    /** Long enough for a checkpoint or two, and for the whole run's end now and then. */
    private static final int LONGEST_MILLIS = 2500;
    private static final double DURATION = 16;
    private static final int STOPPED_BY_SIGTERM = 143;
    private static final int STOPPED_BY_SIGKILL = 137;

    @TempDir
    Path top;

    @Test
    void leaveWholeFilesAndAreContinuedBitForBit() throws Exception {
        long seed = Long.getLong("desolver.seed", System.nanoTime());
        System.out.println("KilledRunsTest: -Ddesolver.seed=" + seed);
        Random random = new Random(seed);
        Path scene = FaultScene.write(top.resolve("scene.yaml"), DURATION);
        Path whole = top.resolve("whole");
        assertEquals(0, child().run("run", "--scene=" + scene, "--out=" + whole).code());
        Map<String, String> expected = WholeFiles.sums(whole);

        int resumed = 0;
        int finished = 0;
        Path out = top.resolve("out0");
        for (int kill = 0; kill < KILLS;) {
            boolean resume = Files.exists(out.resolve("checkpoint"));
            resumed += resume ? 1 : 0;
            String moment = "seed " + seed + ", kill " + kill;
            ChildProgram child = child();
            Process process = child.start("run", "--scene=" + scene, "--out=" + out, "--resume=" + resume);
            boolean ended = process.waitFor(random.nextInt(LONGEST_MILLIS), TimeUnit.MILLISECONDS);
            if (!ended) {
                kill++;
                kill(process, random.nextBoolean(), moment, child);
            } else {
                assertEquals(0, process.exitValue(), moment + ": " + child.lines());
                assertEquals(expected, WholeFiles.sums(out), moment);
                out = top.resolve("out" + ++finished);
            }
            WholeFiles.assertWhole(out);
        }
        boolean resume = Files.exists(out.resolve("checkpoint"));
        ChildProgram.End end = child().run("run", "--scene=" + scene, "--out=" + out, "--resume=" + resume);
        assertEquals(0, end.code(), end.lines());
        assertEquals(expected, WholeFiles.sums(out), "seed " + seed);
        assertTrue(resumed >= KILLS / 5, "only " + resumed + " of " + KILLS + " were continued");
        System.out.println("KilledRunsTest: " + resumed + " times continued, " + (finished + 1) + " times to the end");
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
