package particles;

/**
 * Thrown when the kinetic energy of a run exceeds the scene's limit, almost always because deltaT is too long for the
 * solver.
 */
public final class BlowUpException extends SimulationException {
    private static final long serialVersionUID = 1L;

    /**
     * @param time     the simulated time (s)
     * @param particle the index of the fastest particle
     * @param message  the message to the user
     */
    public BlowUpException(double time, int particle, String message) {
        super(time, particle, message, null);
    }
}
