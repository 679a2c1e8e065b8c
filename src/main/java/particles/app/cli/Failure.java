package particles.app.cli;

/** Ends the program with an exit code and, unless all has been said, a message without a stack trace. */
public final class Failure extends RuntimeException {
    private static final long serialVersionUID = 1L;

    private final ExitCode exitCode;

    /**
     * @param exitCode the exit code
     * @param message  the reason, in lines; may be empty
     */
    public Failure(ExitCode exitCode, String message) {
        super(message);
        this.exitCode = exitCode;
    }

    /** @return the exit code */
    public ExitCode getExitCode() {
        return exitCode;
    }
}
