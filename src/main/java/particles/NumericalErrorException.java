package particles;

/** A run whose numerical error is larger than its energy, so that its motion says nothing of the physics. */
public final class NumericalErrorException extends SimulationException {
    private static final long serialVersionUID = 1L;

    private final boolean early;

    /**
     * @param time     when the error became too large (s)
     * @param particle the index of the particle that moves with the largest energy then
     * @param message  how large the error is
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
