package particles;

/**
 * Reads along and changes nothing: the trajectory has the same bits with and without it. Called by simulated time.
 */
public interface Observer {

    /**
     * Before the first step.
     *
     * @param system the system at its initial state, to be read only
     */
    default void started(ParticleSystem system) {
    }

    /**
     * Until which time the observer needs nothing. Steps that end earlier are not reported to it, so that a frame every
     * 1/25 s costs nothing in the many steps between.
     *
     * @return the next simulated time of interest (s); negative infinity for every step
     */
    default double getNextTime() {
        return Double.NEGATIVE_INFINITY;
    }

    /**
     * A step was made, and no rule has acted yet.
     *
     * @param motion the smooth motion from the step's beginning to its end; valid until the next step begins
     */
    default void moved(Motion motion) {
    }

    /**
     * A rule changed something at the end of the motion that was just reported, or at the end of a step that was not.
     * Told to every observer, whatever its next time, once for each rule that changed something.
     *
     * @param system the system after the change, to be read only
     * @param rule   the rule that made it
     */
    default void changed(ParticleSystem system, Rule rule) {
    }

    /**
     * After the last step.
     *
     * @param system the system at its final state, to be read only
     */
    default void finished(ParticleSystem system) {
    }
}
