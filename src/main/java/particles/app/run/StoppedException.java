package particles.app.run;

/** A run that is ended before its time because somebody asked for it. */
final class StoppedException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    StoppedException() {
        super("the run was stopped");
    }
}
