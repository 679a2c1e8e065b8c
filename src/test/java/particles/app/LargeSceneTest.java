package particles.app;

import static deSolvers.problems.Bounds.assertBelow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import particles.app.cli.ExitCode;

/**
 * A run with 250,000 particles and all outputs, in a child process with only the memory that it estimates. A state is
 * 12 MB, so a trajectory in memory, or objects for particles, would not fit.
 */
@Tag("hard")
class LargeSceneTest {
    private static final int PARTICLES = 250_000;
    private static final int STEPS = 30;
    private static final int STRIDE = 10;
    /** Extra heap for the garbage collector, which Java does not count as usable. */
    private static final double COLLECTOR = 1.2;
    private static final String SCENE = """
            title: A quarter of a million
            teaches: what is large is streamed
            solver: symplectic-euler
            deltaT: 0.001
            duration: 0.03
            shapes:
              - cloth: {corner: [-1, 0, -1], across: [2, 0, 0], down: [0, 0, 2], columns: 500, rows: 500,
                    totalMass: 0.6,
                        fixed: [top-left, top-right], structural: {stiffness: 0.5, damping: 1e-4},
                              shear: {stiffness: 0.2},
                        bend: {stiffness: 0.05}}
            effects:
              - gravity
              - drag: {coefficient: 2e-6}
            output:
              frameRate: 100
              width: 640
              height: 360
              video: mp4
              phase: {particle: "cloth[250,250]", axis: y}
              trajectoryStride: 10
            """;

    @TempDir
    private Path folder;

    private ChildProgram.End run(String heap, Path scene, Path out) throws IOException, InterruptedException {
        return new ChildProgram(folder.resolve("lines.txt")).jvm("-Xmx" + heap).run("run", "--scene=" + scene,
                "--out=" + out);
    }

    @Test
    void aLargeSceneRunsInItsEstimatedMemory() throws Exception {
        Path scene = Files.writeString(folder.resolve("large.yaml"), SCENE);
        Path out = folder.resolve("out");
        ChildProgram.End refused = run("256m", scene, out);
        assertEquals(ExitCode.BAD_INPUT.code(), refused.code(), refused.lines());
        Matcher needed = Pattern.compile(
                "needs about (\\d+) MiB of memory for 250000 particles").matcher(refused.lines());
        assertTrue(needed.find(), refused.lines());
        int megabytes = Integer.parseInt(needed.group(1));
        assertBelow(1024, megabytes, "half of 2 GB");

        ChildProgram.End end = run((int) (COLLECTOR * megabytes) + "m", scene, out);
        assertEquals(ExitCode.DONE.code(), end.code(), end.lines());
        for (String file : List.of("animation.gif", "film.mp4", "energy.png", "phase.png", "run.json")) {
            assertTrue(Files.size(out.resolve(file)) > 0, file);
        }
        try (Stream<Path> frames = Files.list(out.resolve("frames"));
                Stream<String> lines = Files.lines(out.resolve("trajectory.csv"))) {
            assertEquals(4, frames.count());
            assertEquals(1 + (STEPS / STRIDE + 1) * PARTICLES, lines.count());
        }
    }
}
