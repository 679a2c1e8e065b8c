package particles;

/** A read-only listener of a run; the trajectory has the same bits with and without it. */
public interface Observer {

    /**
     * Called before the first step.
     *
     * @param system the system in its initial state; read only
     */
    default void started(ParticleSystem system) {
    }

    /**
     * Returns the next time at which the observer wants to be called. Steps that end earlier are not reported to it, so
     * a frame every 1/25 s costs nothing in the steps between.
     *
     * @return the next simulated time of interest (s); negative infinity for every step
     */
    default double getNextTime() {
        return Double.NEGATIVE_INFINITY;
    }

    /**
     * Called after a step, before any rule has acted.
     *
     * @param motion the smooth motion from the step's beginning to its end; valid until the next step begins
     */
    default void moved(Motion motion) {
    }

    /**
     * Called after a rule changed something at the end of a step. Every observer is told of every change, whatever its
     * next time.
     *
     * @param system the system after the change; read only
     * @param rule   the rule that made it
     */
    default void changed(ParticleSystem system, Rule rule) {
    }

    /**
     * Called after the last step.
     *
     * @param system the system in its final state; read only
     */
    default void finished(ParticleSystem system) {
    }
}
