package particles.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The program in a child process that is stopped by a signal, as by Ctrl-C or a shutdown. */
class StoppedProgramTest {
    @TempDir
    Path top;

    private Process start(Path out, String... more) throws IOException {
        String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
        List<String> command = new ArrayList<>(List.of(java, "-cp", System.getProperty("java.class.path"),
                "particles.app.Main", "run", "--scene=scenes/02-one-spring.yaml",
                "--out=" + out));
        command.addAll(List.of(more));
        return new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(top.resolve("lines.txt").toFile())
                .start();
    }

    private void awaitFile(Process process, Path file) throws InterruptedException, IOException {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(ChildProgram.PATIENCE_SECONDS);
        while (!Files.exists(file)) {
            assertTrue(process.isAlive() && System.nanoTime() < end, Files.readString(top.resolve("lines.txt")));
            Thread.sleep(20);
        }
    }

    @Test
    void aStoppedRunLeavesWholeFilesOnly() throws Exception {
        Path out = top.resolve("out");
        Process process = start(out, "--duration=10000");
        awaitFile(process, out.resolve("frames/frame-00002.png"));
        process.destroy();
        assertTrue(process.waitFor(ChildProgram.PATIENCE_SECONDS, TimeUnit.SECONDS));
        assertNotEquals(0, process.exitValue());
        try (Stream<Path> files = Files.walk(out)) {
            assertEquals(List.of(), files.map(Path::toString).filter(name -> name.endsWith(".part")).toList());
        }
        try (Stream<Path> frames = Files.list(out.resolve("frames"))) {
            for (Path frame : frames.toList()) {
                assertEquals(960, ImageIO.read(frame.toFile()).getWidth(), frame.toString());
            }
        }
        for (String name : List.of("animation.gif", "energy.png", "phase.png", "run.json")) {
            assertTrue(Files.size(out.resolve(name)) > 0, name);
        }
        List<String> rows = Files.readAllLines(out.resolve("trajectory.csv"));
        assertTrue(rows.stream().allMatch(row -> row.split(",").length == 8), "each line has all columns");
    }

    @Test
    void exitCodesReachTheSystem() throws Exception {
        assertEquals(0, start(top.resolve("a"), "--duration=0.1", "--frames=false").waitFor());
        Files.writeString(top.resolve("file"), "mine");
        assertEquals(1, start(top.resolve("file")).waitFor());
        assertEquals(2, start(top.resolve("b"), "--deltaT=-1").waitFor());
        assertEquals(3, start(top.resolve("c"), "--deltaT=10", "--duration=1000", "--frames=false").waitFor());
    }
}
