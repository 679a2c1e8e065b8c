package deSolvers;

/**
 * A source that is told where it was between the sub-steps of an adaptive solver, for those who watch the motion within
 * a long step. The results have the same bits as through the plain {@link DEStateSource}.
 */
public interface SubStepSource extends DEStateSource {

    /**
     * Called after each sub-step that is taken, so once at least in a step.
     *
     * @param state the state there; n long, to be read only, valid during the call
     * @param time  the time there (s)
     */
    void subStepTaken(double[] state, double time);
}
