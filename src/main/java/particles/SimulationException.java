package particles;

/**
 * A run that cannot go on: a step failed, the energy grew beyond what the scene allows, or no forces keep all that is
 * to be kept.
 */
public class SimulationException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    private final double time;
    private final int particle;

    /**
     * @param time     the simulated time (s)
     * @param particle the index of the particle that shows the trouble, or -1
     * @param message  what happened
     * @param cause    the exception that says so, or null where the loop itself noticed
     */
    public SimulationException(double time, int particle, String message, Throwable cause) {
        super(message, cause);
        this.time = time;
        this.particle = particle;
    }

    /** @return the simulated time (s) */
    public double getTime() {
        return time;
    }

    /** @return the index of the particle that shows the trouble, or -1 */
    public int getParticle() {
        return particle;
    }
}
