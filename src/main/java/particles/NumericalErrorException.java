package particles;

/**
 * Thrown when the numerical error of a run is larger than its energy, so that its motion says nothing about the
 * physics.
 */
public final class NumericalErrorException extends SimulationException {
    private static final long serialVersionUID = 1L;

    private final boolean early;

    /**
     * @param time     the simulated time at which the error became too large (s)
     * @param particle the index of the particle with the largest kinetic energy at that time
     * @param message  the message to the user, with the size of the error
     * @param early    whether the run ended there, before its duration was over
     */
    public NumericalErrorException(double time, int particle, String message, boolean early) {
        super(time, particle, message, null);
        this.early = early;
    }

    /** @return whether the run ended at this time, before its duration was over */
    public boolean isEarly() {
        return early;
    }
}
