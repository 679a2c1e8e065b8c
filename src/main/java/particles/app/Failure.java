package particles.app;

import java.util.List;

/** What a person can put right, said in lines that need no stack trace. */
final class Failure extends RuntimeException {
    private static final long serialVersionUID = 1L;

    private final ExitCode exitCode;
    private final transient List<String> lines;

    /**
     * @param exitCode how the program ends
     * @param lines    what is wrong, each line clear on its own
     */
    Failure(ExitCode exitCode, List<String> lines) {
        super(String.join(System.lineSeparator(), lines));
        this.exitCode = exitCode;
        this.lines = List.copyOf(lines);
    }

    /**
     * @param exitCode how the program ends
     * @param line     what is wrong
     */
    Failure(ExitCode exitCode, String line) {
        this(exitCode, List.of(line));
    }

    ExitCode exitCode() {
        return exitCode;
    }

    List<String> lines() {
        return lines;
    }
}
