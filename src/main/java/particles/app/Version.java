package particles.app;

/** Which version of the program this is. */
final class Version {
    /** The version, as run.json has it; the same as in build.gradle. */
    static final String CURRENT = "0.1.0";

    private Version() {
    }
}
