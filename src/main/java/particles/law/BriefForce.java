package particles.law;

/**
 * A force law that may act for less time than a step takes: a small ball that fast particles pass, or gusts of wind. It
 * reports that time, so that adaptive solvers do not step across it, and steps that are too long are reported. A law
 * adds this interface if its force begins, or reverses, within a length or a time of its own.
 */
public interface BriefForce extends Effect {

    /**
     * Returns the shortest time in which the force on any particle may come and go: the length over which it acts
     * divided by the speed of the particle that crosses it fastest, or the period of the force.
     *
     * @param state the particles' state; read only
     * @param time  t (s)
     * @return the time, positive (s); infinite if nothing moves
     */
    double getShortestTime(double[] state, double time);

    /**
     * Looks for a passage through the reach of the force that is felt at neither end of a sub-step: one that grazes it,
     * and is shorter than {@link #getShortestTime} says.
     *
     * @param from     the particles' state at the beginning; read only
     * @param to       the state at the end; read only
     * @param duration the duration (s); negative if the sub-step goes backwards in time
     * @return the duration of a sub-step that does not miss the passage, see {@link Passage} (s, positive); infinite if
     *         there is none, and by default
     */
    default double findPassage(double[] from, double[] to, double duration) {
        return Double.POSITIVE_INFINITY;
    }
}
