package particles.app.cli;

/** The exit codes of the program. */
public enum ExitCode {
    /** Success. */
    DONE(0),
    /** An internal error, or a problem with files, such as a full disk. */
    TROUBLE(1),
    /** An invalid option, scene or exercise. */
    BAD_INPUT(2),
    /** The simulation stopped early, for example because it blew up. */
    STOPPED(3);

    private final int code;

    ExitCode(int code) {
        this.code = code;
    }

    /** @return the number for the operating system */
    public int code() {
        return code;
    }
}
