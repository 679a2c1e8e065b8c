package particles.app.cli;

import deSolvers.DESolverException;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.nio.file.NotDirectoryException;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import particles.SimulationException;
import particles.output.files.OutputException;
import particles.spec.messages.InvalidInputException;

/**
 * Prints exceptions: expected failures as clear lines, anything else with a stack trace.
 *
 * @param err the error stream
 */
public record Failures(PrintWriter err) {
    /** Failures that need no stack trace. */
    private static final Set<Class<?>> EXPECTED = Set.of(Failure.class, InvalidInputException.class,
            SimulationException.class, DESolverException.class, OutputException.class);
    private static final Map<Class<?>, String> REASONS = Map.of(AccessDeniedException.class, "permission denied",
            NoSuchFileException.class, "no such file or folder", NotDirectoryException.class, "not a folder",
            FileAlreadyExistsException.class, "exists already and is not a folder");

    /**
     * Prints an exception.
     *
     * @param thrown the exception of a command
     * @return the exit code
     */
    public ExitCode print(Throwable thrown) {
        if (thrown instanceof UncheckedIOException unchecked) {
            return print(unchecked.getCause());
        }
        if (thrown instanceof IOException io) {
            err.println(line(io));
        } else if (thrown instanceof OutOfMemoryError) {
            err.printf(Locale.ROOT,
                    "out of memory: Java may use %d MiB; use fewer particles, frames or runs, or give Java more:"
                    + " JAVA_TOOL_OPTIONS=-Xmx%dg%n", Runtime.getRuntime().maxMemory() >> 20,
                    (Runtime.getRuntime().maxMemory() >> 30) + 1);
        } else if (EXPECTED.stream().anyMatch(type -> type.isInstance(thrown))) {
            message(thrown).lines().forEach(err::println);
        } else {
            err.println("internal error; please report it:");
            thrown.printStackTrace(err);
        }
        return thrown instanceof Failure failure ? failure.getExitCode()
                : thrown instanceof InvalidInputException ? ExitCode.BAD_INPUT
                : thrown instanceof SimulationException || thrown instanceof DESolverException ? ExitCode.STOPPED
                : ExitCode.TROUBLE;
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
