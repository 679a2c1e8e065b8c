package particles.app.cli;

/** Which version of the program this is. */
public final class Version {
    /** The version, as run.json has it; the same as in build.gradle. */
    public static final String CURRENT = "0.1.0";

    private Version() {
    }
}
