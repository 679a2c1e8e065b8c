package particles.app.student;

import java.io.IOException;
import java.io.OutputStream;
import java.math.BigInteger;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import particles.app.cli.ExitCode;
import particles.app.cli.Failure;
import particles.app.cli.OptionStyle;

/** Runs code that calls a student's class in a child process, so that the class cannot stop the program. */
final class StudentProcess {
    private static final String PROGRAM = "particles.app.Main";      // by name: it imports the commands
    private static final int MEGABYTES = 256;
    /** A check has 7 s of CPU time in its process, beside what the machine needs to start. */
    private static final Duration MOST_CPU_TIME = Duration.ofSeconds(40);
    /** A busy machine gives it an eighth of a processor, or less. */
    private static final int SECONDS = 900;
    private static final int DIGITS = 128;
    /** The option for a check to read a number from its input and begin every line with it. */
    static final String NUMBERED = "--numbered";

    private StudentProcess() {
    }

    /**
     * The result of a process.
     *
     * @param code  the check's verdict: DONE is right, STOPPED is not decided, all others are wrong
     * @param lines the check's own lines, without those that the class printed
     */
    record Outcome(ExitCode code, List<String> lines) {
    }

    /**
     * Runs a check in a process with little memory. The class may print anything and end the process at any time with
     * any exit code. So only lines that begin with a random number count as the check's own, and the last of them is
     * the verdict. The check reads the number from its input before the class is loaded.
     *
     * @param args   the command and its options
     * @param folder the folder of the student's classes; empty for the default
     * @return the result
     * @throws IOException if no process can be made
     */
    static Outcome run(List<String> args, Optional<Path> folder) throws IOException {
        String number = new BigInteger(DIGITS, new SecureRandom()).toString();
        Path screen = Files.createTempFile("desolver-check", ".txt");
        try {
            List<String> properties = folder.map(Path::toString)
                    .or(() -> Optional.ofNullable(System.getProperty(StudentLoader.FOLDER))).stream()
                    .map(StudentProcess::property).toList();
            List<String> numbered = new ArrayList<>(args);
            numbered.add(NUMBERED);
            await(builder(numbered, properties).redirectErrorStream(true).redirectOutput(screen.toFile()), number);
            return outcome(lines(screen), number);
        } finally {
            Files.delete(screen);
        }
    }

    /** Selects the lines that begin with the number; the last one has to be the verdict. */
    static Outcome outcome(List<String> printed, String number) {
        List<String> own = printed.stream().filter(line -> line.startsWith(number + " "))
                .map(line -> line.substring(number.length() + 1)).toList();
        for (ExitCode code : ExitCode.values()) {
            if (!own.isEmpty() && own.get(own.size() - 1).equals(code.name())) {
                return new Outcome(code, own.subList(0, own.size() - 1));
            }
        }
        return new Outcome(ExitCode.BAD_INPUT, List.of("wrong: the check did not finish; the class ended the program"));
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

    private static void await(ProcessBuilder builder, String number) throws IOException {
        Process process = builder.start();
        try (OutputStream input = process.getOutputStream()) {
            input.write((number + System.lineSeparator()).getBytes(StandardCharsets.UTF_8));
            input.flush();
            for (int second = 0; second < SECONDS; second++) {
                if (process.waitFor(1, TimeUnit.SECONDS)) {
                    return;
                }
                if (process.info().totalCpuDuration().filter(time -> time.compareTo(MOST_CPU_TIME) > 0).isPresent()) {
                    throw new Failure(ExitCode.BAD_INPUT, "wrong: the check did not end within "
                            + MOST_CPU_TIME.toSeconds() + " s of CPU time and was stopped");
                }
            }
            throw new Failure(ExitCode.STOPPED, "not decided on this machine, which is too busy: run it again");
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new Failure(ExitCode.STOPPED, "the check was interrupted");
        } finally {
            process.destroyForcibly();
        }
    }
}
