package particles;

/**
 * Thrown when a run cannot go on: a step failed, the energy exceeded its limit, or rods and wires contradict each
 * other.
 */
public class SimulationException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    /** What ends a run. */
    public enum End {
        /** A step failed, or rods, wires and contacts contradict each other. */
        FAILURE,
        /** The kinetic energy exceeded the scene's limit, almost always because deltaT is too long for the solver. */
        ENERGY_LIMIT,
        /** The numerical error became far larger than the energy. */
        NUMERICAL_ERROR,
        /** Its duration, but the numerical error is larger than the energy: the motion says nothing about physics. */
        WRONG_MOTION,
        /** Contacts open and close so often that a step does not end. */
        NO_HEADWAY,
    }

    private final End end;
    private final double time;
    private final int particle;

    /**
     * Describes a failure.
     *
     * @param time     the simulated time (s)
     * @param particle the index of the particle concerned, or -1
     * @param message  the message to the user
     * @param cause    the cause, or null if the loop itself found the problem
     */
    public SimulationException(double time, int particle, String message, Throwable cause) {
        this(End.FAILURE, time, particle, message);
        initCause(cause);
    }

    /**
     * @param end      what ended the run
     * @param time     the simulated time (s); of a wrong motion, that from which on it is wrong
     * @param particle the index of the particle concerned, such as the fastest one, or -1
     * @param message  the message to the user
     */
    public SimulationException(End end, double time, int particle, String message) {
        super(message);
        this.end = end;
        this.time = time;
        this.particle = particle;
    }

    /** @return what ended the run */
    public End getEnd() {
        return end;
    }

    /** @return the simulated time (s) */
    public double getTime() {
        return time;
    }

    /** @return the index of the particle concerned, or -1 */
    public int getParticle() {
        return particle;
    }
}
