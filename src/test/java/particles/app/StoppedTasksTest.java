package particles.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import particles.OtherSystems;
import particles.app.cli.ProgramCommand;
import particles.app.run.StopRequest;

/**
 * Each task is stopped by a signal at three moments: it ends soon, with one line, and leaves no unfinished file, no
 * lock, no temporary copy and no process behind.
 */
@Tag("slow")
class StoppedTasksTest {
    private static final int STOPPED_BY_SIGTERM = 143;
    /** Measured: 0.04 to 0.13 s on two idle cores, of a run 0.7 s; a busy machine may be much slower (ms). */
    private static final long SOON = 10_000;
    /** After the folder of results is there, or the task had time to begin (ms). */
    private static final long[] MOMENTS = {0, 700, 2500};
    private static final String ENDLESS = """
            package exercises;
            public class %s extends deSolvers.DESolver {
                public void stepState(deSolvers.DEStateSource source, double deltaT) {
                    while (source.getTime() < 1e300) { source.incTime(0); }
                }
            }
            """;

    @TempDir
    Path top;

    /** Those that only print a few lines end before a signal reaches them; the lab's page has another class path. */
    static Stream<String> tasks() {
        return Main.commands(new StopRequest()).stream().map(ProgramCommand::name).filter(name -> !List.of("scenes",
                "solvers", "exercise", "newSolver", "newEffect", "autograding", "sheets", "lab", "gallery",
                "checkEffect").contains(name));
    }

    private List<String> arguments(String task) throws IOException {
        List<String> arguments = new ArrayList<>(List.of(task, "--out=" + top.resolve("out")));
        switch (task) {
            case "run" -> arguments.add("--scene=" + FaultScene.write(top.resolve("scene.yaml"), 1000));
            case "sweep" -> arguments.addAll(List.of("--scene=" + FaultScene.write(top.resolve("scene.yaml"), 1000),
                    "--vary=deltaT=0.0005,0.00025", "--measure=steps"));
            case "checkSolver" -> arguments.add("--solver=exercises.EndlessSolver");
            case "grade" -> arguments.add("--student=ann");
            case "gradeClass" -> arguments.add("--folder=" + handIn("ann").getParent());
            default -> {
                return arguments;
            }
        }
        return arguments;
    }

    private Path handIn(String student) throws IOException {
        Path folder = Files.createDirectories(top.resolve("class").resolve(student));
        Files.writeString(folder.resolve("MySolver.java"), ENDLESS.formatted("MySolver"));
        return folder;
    }

    @ParameterizedTest
    @MethodSource("tasks")
    void aStoppedTaskEndsWithOneLineAndLeavesNothingBehind(String task) throws Exception {
        OtherSystems.assumeSignals();
        Path temporary = Files.createDirectory(top.resolve("temporary"));
        Path exercises = Files.createDirectory(top.resolve("exercises"));
        Files.writeString(exercises.resolve("EndlessSolver.java"), ENDLESS.formatted("EndlessSolver"));
        int stopped = 0;
        for (long moment : MOMENTS) {
            ChildProgram child = new ChildProgram(top.resolve("lines.txt")).jvm("-Djava.io.tmpdir=" + temporary,
                    "-Ddesolver.exercises=" + exercises);
            Process process = child.start(arguments(task).toArray(String[]::new));
            for (int i = 0; i < 1000 && process.isAlive() && isEmpty(top.resolve("out")) && isEmpty(temporary); i++) {
                Thread.sleep(10);
            }
            process.waitFor(moment, TimeUnit.MILLISECONDS);
            List<ProcessHandle> children = process.descendants().toList();
            long begin = System.nanoTime();
            process.destroy();
            ChildProgram.End end = child.end(process);
            String what = task + " after " + moment + " ms: " + end.lines();
            if (end.code() == STOPPED_BY_SIGTERM) {
                stopped++;
                assertTrue(TimeUnit.NANOSECONDS.toMillis(System.nanoTime() - begin) < SOON, what);
                assertTrue(end.lastLine().matches(task + " was stopped.*|the run was stopped at t = .* s"), what);
                assertFalse(end.lines().contains("Exception") || end.lines().contains("error;"), what);
            }
            assertEquals(List.of(), leftOver(top.resolve("out")), what);
            assertEquals(List.of(), children.stream().filter(ProcessHandle::isAlive).toList(), what);
            assertTrue(isEmpty(temporary), what);
        }
        assertTrue(stopped > 0, "it always ended before it was stopped");
    }

    private static boolean isEmpty(Path folder) throws IOException {
        if (!Files.exists(folder)) {
            return true;
        }
        try (Stream<Path> files = Files.list(folder)) {
            return files.findAny().isEmpty();
        }
    }

    private static List<Path> leftOver(Path folder) throws IOException {
        if (!Files.exists(folder)) {
            return List.of();
        }
        try (Stream<Path> files = Files.walk(folder)) {
            return files.filter(file -> file.getFileName().toString().matches("[.].*([.]part|-writing)")).toList();
        }
    }
}
