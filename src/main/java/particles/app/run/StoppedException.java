package particles.app.run;

/** Thrown when a run is stopped early on request. */
final class StoppedException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    StoppedException() {
        super("the run was stopped");
    }
}
