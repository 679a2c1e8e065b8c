package particles.app.student;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.lang.ProcessBuilder.Redirect;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import particles.app.cli.ExitCode;
import particles.output.files.TemporaryFolder;
import particles.spec.Digest;

/** Runs code that calls a student's class in a child process, so that the class cannot stop the program. */
public final class StudentProcess {
    private static final int MEGABYTES = 256;
    /** A check ends itself within 700 s, unless its class found a way to keep it from that. */
    private static final int SECONDS = 900;
    /** A process that Ctrl-C, kill or a lack of memory ended has an exit code over this. */
    private static final int SIGNAL = 128;
    private static final int SECRET = 32;
    private static final String END = "\0";
    /** Where the classes begin, after the secret, the folder and the check. */
    private static final int CLASSES = 5;
    private static final int LONGEST = 1 << 20;

    private StudentProcess() {
    }

    /**
     * The result of a process.
     *
     * @param code  the check's verdict: DONE is right, STOPPED is not decided, all others are wrong
     * @param lines the check's own lines, without those that the class printed
     */
    public record Outcome(ExitCode code, List<String> lines) {
    }

    /**
     * What signs a verdict. A check reads it from its input before it loads the class; it is never written anywhere.
     */
    record Secret(String key) {
        /** @return the text with a signature that only a holder of the secret can make, on a line before it */
        private String signed(String text) {
            return Digest.of(key + Digest.of(key + text)) + "\n" + text;   // twice, as in HMAC: none can be extended
        }

        /** @return the outcome as a signed text */
        byte[] sign(Outcome outcome) {
            return signed(outcome.code() + "\n" + String.join("\n", outcome.lines())).getBytes(StandardCharsets.UTF_8);
        }

        /** @return the outcome in a text that {@link #sign} made with this secret; of any other, a wrong one */
        Outcome read(byte[] verdict) {
            String text = new String(verdict, StandardCharsets.UTF_8);
            List<String> lines = text.lines().skip(1).toList();
            return signed(String.join("\n", lines)).equals(text) && !lines.isEmpty() ? new Outcome(ExitCode.valueOf(
                    lines.get(0)), lines.subList(1, lines.size())) : new Outcome(ExitCode.BAD_INPUT, List.of(
                    "wrong: the check did not finish; the class ended the program"));
        }
    }

    /**
     * Runs a check in a process with little memory. The class may print anything and end the process at any time with
     * any exit code. So only a signed verdict counts; the rest of what is printed goes nowhere.
     *
     * @param check   the check
     * @param folder  receives its report
     * @param sources the text of the student's classes
     * @return the result
     * @throws UncheckedIOException if no process can be made
     */
    public static Outcome run(Check check, Path folder, Map<String, String> sources) {
        byte[] random = new byte[SECRET];
        new SecureRandom().nextBytes(random);
        Secret secret = new Secret(HexFormat.of().formatHex(random));
        List<String> input = new ArrayList<>(List.of(secret.key(), folder.toString(), check.command(), check.subject(),
                check.method()));
        sources.forEach((name, text) -> input.addAll(List.of(name, text.replace(END, "?"))));    // no Java either way
        try (TemporaryFolder own = new TemporaryFolder("desolver-check")) {
            Path verdict = own.getPath().resolve("verdict");
            Optional<Outcome> stopped = await(builder(verdict).redirectErrorStream(true)
                    .redirectOutput(Redirect.DISCARD), String.join(END, input));
            return stopped.isPresent() ? stopped.get() : secret.read(Files.isRegularFile(verdict,
                    LinkOption.NOFOLLOW_LINKS) && Files.size(verdict) <= LONGEST ? Files.readAllBytes(verdict)
                    : new byte[0]);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /**
     * The process of a check: reads the secret, the check and the classes from its input, where no other check can
     * change them any more, and writes the signed verdict. Java's serialization would take 100 ms to load.
     *
     * @param args the file of the verdict
     * @throws IOException if the input cannot be read
     */
    public static void main(String[] args) throws IOException {
        List<String> input = List.of(new String(System.in.readAllBytes(), StandardCharsets.UTF_8).split(END, -1));
        Secret secret = new Secret(input.get(0));
        Map<String, String> sources = new TreeMap<>();          // the class's loader must not lead to the secret
        for (int i = CLASSES; i < input.size(); i += 2) {
            sources.put(input.get(i), input.get(i + 1));
        }
        new StudentLoader(() -> sources).install();
        new CheckRun(new Check(input.get(2), input.get(3), input.get(4)), Path.of(input.get(1)),
                (code, report) -> end(Path.of(args[0]), secret, code, report)).run();
    }

    /** Writes the verdict once and ends the process, in which code of the class may still be running. */
    private static synchronized void end(Path verdict, Secret secret, ExitCode code, List<String> report) {
        try {
            Files.write(verdict, secret.sign(new Outcome(code, report.stream().flatMap(String::lines).toList())));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        } finally {
            Runtime.getRuntime().halt(code.code());
        }
    }

    /**
     * Without verifying bytecode, which takes a sixth of the compiler's time. A class that makes bytecode of its own
     * can crash the process, as it can with Unsafe.
     */
    private static ProcessBuilder builder(Path verdict) {
        return new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Xmx" + MEGABYTES + "m", "-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC",
                "-XX:+IgnoreUnrecognizedVMOptions", "-XX:+UnlockDiagnosticVMOptions",
                "-XX:-BytecodeVerificationRemote", "-Djava.awt.headless=true",
                "-cp", System.getProperty("java.class.path"), StudentProcess.class.getName(), verdict.toString());
    }

    /** @return the outcome of a process that did not end by itself */
    private static Optional<Outcome> await(ProcessBuilder builder, String input) throws IOException {
        Process process = builder.start();
        try {
            try (OutputStream output = process.getOutputStream()) {     // the check reads it to the end
                output.write(input.getBytes(StandardCharsets.UTF_8));
            }
            return process.waitFor(SECONDS, TimeUnit.SECONDS) ? undecided("the check was ended from outside").filter(
                    outcome -> process.exitValue() > SIGNAL) : undecided("the check took more than " + SECONDS + " s");
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return undecided("the check was interrupted");
        } finally {
            process.descendants().forEach(ProcessHandle::destroyForcibly);
            process.destroyForcibly();
        }
    }

    private static Optional<Outcome> undecided(String line) {
        return Optional.of(new Outcome(ExitCode.STOPPED, List.of("not decided: " + line + "; run it again")));
    }
}
