package particles.app.cli;

import java.util.List;

/** A failure that the user can fix, reported in lines without a stack trace. */
public final class Failure extends RuntimeException {
    private static final long serialVersionUID = 1L;

    private final ExitCode exitCode;
    private final transient List<String> lines;

    /**
     * @param exitCode the exit code
     * @param lines    the problems, each line clear on its own
     */
    public Failure(ExitCode exitCode, List<String> lines) {
        super(String.join(System.lineSeparator(), lines));
        this.exitCode = exitCode;
        this.lines = List.copyOf(lines);
    }

    /**
     * @param exitCode the exit code
     * @param line     the problem
     */
    public Failure(ExitCode exitCode, String line) {
        this(exitCode, List.of(line));
    }

    /** @return the exit code */
    public ExitCode getExitCode() {
        return exitCode;
    }

    /** @return the message, line by line */
    public List<String> getLines() {
        return lines;
    }
}
