package deSolvers;

/**
 * A source that knows for how short a time its derivative may change, as where a fast particle passes a small post or
 * an anchor is shaken. A sub-step that is longer may begin before the change and end after it, and no estimate of the
 * error sees what none of its stages saw. Adaptive solvers keep their sub-steps below that time. The results of a
 * source without such changes are the same, bit for bit, as with a plain {@link DEStateSource}.
 */
public interface TimeScaleSource extends DEStateSource {
    /** Sub-steps are at most this fraction of the time: four in each period of a motion. */
    double PART = 0.25;

    /**
     * Returns the shortest time within which the derivative may change and change back.
     *
     * @param state a state; n long, to be read only
     * @param time  its time (s), which need not be that of the clock
     * @return the time, positive (s); infinite if there is no such change
     */
    double getShortestTime(double[] state, double time);

    /**
     * Looks for a change of the derivative that begins and ends within a sub-step, and is small or absent at both of
     * its ends.
     *
     * @param from      the state at the beginning; n long, to be read only
     * @param beginning its time (s)
     * @param to        the state at the end; n long, to be read only
     * @param end       its time (s)
     * @return the duration of a sub-step from the same beginning that does not miss the change (s, positive); infinite
     *         if there is no such change
     */
    double findPassage(double[] from, double beginning, double[] to, double end);
}
