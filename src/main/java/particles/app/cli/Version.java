package particles.app.cli;

/** The version of the program. */
public final class Version {
    /** The version, written to run.json; equal to that in build.gradle. */
    public static final String CURRENT = "0.1.0";

    private Version() {
    }
}
