package particles.app.cli;

import java.util.List;

/** What a person can put right, said in lines that need no stack trace. */
public final class Failure extends RuntimeException {
    private static final long serialVersionUID = 1L;

    private final ExitCode exitCode;
    private final transient List<String> lines;

    /**
     * @param exitCode how the program ends
     * @param lines    what is wrong, each line clear on its own
     */
    public Failure(ExitCode exitCode, List<String> lines) {
        super(String.join(System.lineSeparator(), lines));
        this.exitCode = exitCode;
        this.lines = List.copyOf(lines);
    }

    /**
     * @param exitCode how the program ends
     * @param line     what is wrong
     */
    public Failure(ExitCode exitCode, String line) {
        this(exitCode, List.of(line));
    }

    public ExitCode exitCode() {
        return exitCode;
    }

    public List<String> lines() {
        return lines;
    }
}
