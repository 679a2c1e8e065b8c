package particles.teaching;

/** Ends a student's loop that does not end by itself; an error, as no class that swallows exceptions may go on. */
public final class EndlessLoop extends Error {
    private static final long serialVersionUID = 1L;

    /** @param how how it shows, such as the number of calls */
    public EndlessLoop(String how) {
        super(how);
    }
}
