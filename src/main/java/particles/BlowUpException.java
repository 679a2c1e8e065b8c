package particles;

/**
 * A run whose kinetic energy grew beyond what the scene allows: almost always a time step that the solver cannot take.
 */
public final class BlowUpException extends SimulationException {
    private static final long serialVersionUID = 1L;

    /**
     * @param time     the simulated time (s)
     * @param particle the index of the fastest particle
     * @param message  what happened
     */
    public BlowUpException(double time, int particle, String message) {
        super(time, particle, message, null);
    }
}
