package particles.app.cli;

/** The exit codes of the program, from 0. */
public enum ExitCode {
    /** Success. */
    DONE,
    /** An internal error, or a problem with files, such as a full disk. */
    TROUBLE,
    /** An invalid option, scene or exercise. */
    BAD_INPUT,
    /** The simulation stopped early, for example because it blew up. */
    STOPPED;

    /** @return the number for the operating system */
    public int code() {
        return ordinal();
    }

    /** Ends the program with an exit code and, unless all has been said, a message without a stack trace. */
    public static final class Failure extends RuntimeException {
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
}
