package particles.app.cli;

/** How the program ends, for scripts to read. */
public enum ExitCode {
    /** All was done. */
    DONE(0),
    /** An error of the program's own, or trouble with files, such as a full disk. */
    TROUBLE(1),
    /** An option, a scene or an exercise that is not valid. */
    BAD_INPUT(2),
    /** The simulation stopped, because its numbers had blown up. */
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
