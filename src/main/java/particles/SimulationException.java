package particles;

/**
 * Thrown when a run cannot go on: a step failed, the energy exceeded its limit, or rods and wires contradict each
 * other.
 */
public class SimulationException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    private final double time;
    private final int particle;

    /**
     * @param time     the simulated time (s)
     * @param particle the index of the particle concerned, or -1
     * @param message  the message to the user
     * @param cause    the cause, or null if the loop itself found the problem
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

    /** @return the index of the particle concerned, or -1 */
    public int getParticle() {
        return particle;
    }

    /** Thrown when contacts open and close so often that a step does not end. */
    public static final class NoHeadway extends SimulationException {
        private static final long serialVersionUID = 1L;

        NoHeadway(double time, String why) {
            super(time, -1, "contacts make no headway: " + why, null);
        }
    }
}
