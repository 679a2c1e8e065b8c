package particles.app;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/** Runs the program in a child process, with settings that differ between machines. */
public final class ChildProgram {
    /** Only ends a program that hangs: what a test starts ends within seconds, on a busy machine within a minute. */
    static final int PATIENCE_SECONDS = 600;

    private final Path lines;
    private final List<String> before = new ArrayList<>();
    private final List<String> jvm = new ArrayList<>(List.of("-Djava.awt.headless=true", "-XX:TieredStopAtLevel=1",
            "-XX:+UseSerialGC"));
    private final Map<String, String> environment = new HashMap<>();

    /**
     * The result of the process.
     *
     * @param code  the exit code
     * @param lines what it printed, both streams
     */
    public record End(int code, String lines) {
        String lastLine() {
            return lines.strip().lines().reduce("", (a, b) -> b);
        }
    }

    /** @param lines a file for what it prints */
    public ChildProgram(Path lines) {
        this.lines = lines;
    }

    /** @param options of Java, before the program */
    public ChildProgram jvm(String... options) {
        jvm.addAll(List.of(options));
        return this;
    }

    public ChildProgram environment(String name, String value) {
        environment.put(name, value);
        return this;
    }

    /** @param command a command that starts the program: it gets java and its arguments as arguments */
    ChildProgram startedBy(String... command) {
        before.addAll(List.of(command));
        return this;
    }

    Process start(String... args) throws IOException {
        return startJava(Stream.concat(Stream.of("-cp", System.getProperty("java.class.path"), "particles.app.Main"),
                Stream.of(args)).toArray(String[]::new));
    }

    /** @param args of Java: a class path and a program */
    public Process startJava(String... args) throws IOException {
        List<String> command = new ArrayList<>(before);
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        command.addAll(jvm);
        command.addAll(List.of(args));
        ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(lines.toFile());
        builder.environment().putAll(environment);
        return builder.start();
    }

    End run(String... args) throws IOException, InterruptedException {
        return end(start(args));
    }

    public End end(Process process) throws IOException, InterruptedException {
        if (!process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
            process.destroyForcibly().waitFor();
            throw new AssertionError("still running after " + PATIENCE_SECONDS + " s: " + lines());
        }
        return new End(process.exitValue(), lines());
    }

    /** Its output so far. */
    String lines() throws IOException {
        return new String(Files.readAllBytes(lines), StandardCharsets.UTF_8);
    }
}
