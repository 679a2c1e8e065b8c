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
}
