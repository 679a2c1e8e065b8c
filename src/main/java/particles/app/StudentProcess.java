package particles.app;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;

/** A process of its own for what calls a student's class: whatever the class does there, the program goes on. */
final class StudentProcess {
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
    static int run(List<String> args) throws IOException {
        List<String> line = new ArrayList<>(List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-Xmx" + MEGABYTES + "m",
                "-XX:TieredStopAtLevel=1", "-Djava.awt.headless=true", "-cp", System.getProperty("java.class.path")));
        String startedBy = System.getProperty(OptionStyle.STARTED_BY);
        if (startedBy != null) {                        // null where it was not set
            line.add("-D" + OptionStyle.STARTED_BY + "=" + startedBy);
        }
        line.add(Main.class.getName());
        line.addAll(args);
        Process process = new ProcessBuilder(line).inheritIO().start();
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
