package particles.app.student;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import particles.app.cli.ExitCode;
import particles.app.cli.Failure;
import particles.app.cli.OptionStyle;

/** A process of its own for what calls a student's class: whatever the class does there, the program goes on. */
final class StudentProcess {
    private static final String PROGRAM = "particles.app.Main";      // by name: it imports the commands
    private static final int MEGABYTES = 256;
    private static final int SECONDS = 90;

    private StudentProcess() {
    }

    /**
     * Runs a command of this program in a process with little memory, which writes to the same screen.
     *
     * @param args the command and its options
     * @return its exit code
     * @throws IOException if no process can be made
     */
    public static int run(List<String> args) throws IOException {
        String folder = System.getProperty(StudentLoader.FOLDER);
        // null where it was not set
        return await(builder(args, folder == null ? List.of() : List.of(property(folder))).inheritIO());
    }

    /**
     * How a process ended.
     *
     * @param code  its exit code
     * @param lines what it printed
     */
    record Outcome(int code, List<String> lines) {
    }

    /**
     * Runs a command in such a process, and keeps what it prints.
     *
     * @param args    the command and its options
     * @param folder where the student's classes are
     * @return how it ended
     * @throws IOException if no process can be made
     */
    static Outcome runQuietly(List<String> args, Path folder) throws IOException {
        Path screen = Files.createTempFile("desolver-check", ".txt");
        try {
            ProcessBuilder process = builder(args, List.of(property(folder.toString()))).redirectErrorStream(true)
                    .redirectOutput(screen.toFile());
            try {
                int code = await(process);
                return new Outcome(code, lines(screen));
            } catch (Failure e) {
                return new Outcome(e.exitCode().code(), e.lines());
            }
        } finally {
            Files.delete(screen);
        }
    }

    private static String property(String folder) {
        return "-D" + StudentLoader.FOLDER + "=" + folder;
    }

    private static List<String> lines(Path screen) throws IOException {
        return new String(Files.readAllBytes(screen), StandardCharsets.UTF_8).lines().toList();
    }

    private static ProcessBuilder builder(List<String> args, List<String> properties) {
        List<String> line = new ArrayList<>(List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Xmx" + MEGABYTES + "m",
                "-XX:TieredStopAtLevel=1", "-Djava.awt.headless=true", "-cp", System.getProperty("java.class.path")));
        line.addAll(properties);
        String startedBy = System.getProperty(OptionStyle.STARTED_BY);
        if (startedBy != null) {                        // null where it was not set
            line.add("-D" + OptionStyle.STARTED_BY + "=" + startedBy);
        }
        line.add(PROGRAM);
        line.addAll(args);
        return new ProcessBuilder(line);
    }

    private static int await(ProcessBuilder builder) throws IOException {
        Process process = builder.start();
        try {
            if (process.waitFor(SECONDS, TimeUnit.SECONDS)) {
                return process.exitValue();
            }
            throw new Failure(ExitCode.BAD_INPUT, "the check did not end within " + SECONDS + " s and was stopped");
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new Failure(ExitCode.STOPPED, "the check was interrupted");
        } finally {
            process.destroyForcibly();
        }
    }
}
