package particles.app.cli;

import deSolvers.DESolverException;
import deSolvers.text.Digits;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;
import java.util.List;
import java.util.Map;
import java.util.Set;
import particles.SimulationException;
import particles.app.cli.ExitCode.Failure;
import particles.output.files.OutputException;
import particles.spec.messages.InvalidInputException;

/** Turns exceptions into lines and exit codes: expected failures into clear lines, others with a stack trace. */
public final class Failures {
    /** Failures that need no stack trace. */
    private static final Set<Class<?>> EXPECTED = Set.of(Failure.class, InvalidInputException.class,
            SimulationException.class, DESolverException.class, OutputException.class);
    private static final Map<Class<?>, String> REASONS = Map.of(AccessDeniedException.class, "permission denied",
            NoSuchFileException.class, "no such file or folder", NotDirectoryException.class, "not a folder",
            FileAlreadyExistsException.class, "exists already and is not a folder");

    private Failures() {
    }

    /** @return the exit code for the exception of a command */
    static ExitCode code(Throwable thrown) {
        return thrown instanceof Failure failure ? failure.getExitCode()
                : thrown instanceof InvalidInputException ? ExitCode.BAD_INPUT
                : thrown instanceof SimulationException || thrown instanceof DESolverException ? ExitCode.STOPPED
                : ExitCode.TROUBLE;
    }

    /** @return the lines that tell of the exception of a command */
    public static List<String> lines(Throwable thrown) {
        if (thrown instanceof UncheckedIOException unchecked) {
            return lines(unchecked.getCause());
        }
        if (thrown instanceof IOException io) {
            return List.of(line(io));
        }
        if (thrown instanceof OutOfMemoryError) {
            return List.of(Digits.format("out of memory: Java may use %d MiB; use fewer particles, frames or runs, or"
                    + " give Java more: JAVA_TOOL_OPTIONS=-Xmx%dg", Runtime.getRuntime().maxMemory() >> 20,
                    (Runtime.getRuntime().maxMemory() >> 30) + 1));
        }
        if (EXPECTED.stream().anyMatch(type -> type.isInstance(thrown))) {
            return message(thrown).lines().toList();
        }
        StringWriter trace = new StringWriter();
        thrown.printStackTrace(new PrintWriter(trace));
        return ("internal error; please report it:\n" + trace).lines().toList();
    }

    /**
     * The line for a failed file access. Java's own messages are often only a file name, so the exception's class or
     * cause is used too.
     */
    private static String line(IOException e) {
        if (e instanceof FileSystemException file && file.getReason() == null) {
            return file.getFile() + ": " + REASONS.getOrDefault(e.getClass(), e.getClass().getSimpleName());
        }
        StringBuilder line = new StringBuilder();
        for (Throwable t = e; t != null; t = t.getCause()) {
            if (line.indexOf(message(t)) < 0) {
                line.append(line.isEmpty() ? "" : ": ").append(message(t));
            }
        }
        return line.toString();
    }

    private static String message(Throwable thrown) {
        return thrown.getMessage() == null ? thrown.getClass().getSimpleName() : thrown.getMessage();
    }
}
