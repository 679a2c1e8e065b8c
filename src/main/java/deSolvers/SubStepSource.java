package deSolvers;

/**
 * A state source that an adaptive solver calls after each sub-step, so that the motion within a long step can be
 * recorded. The results are the same, bit for bit, as with a plain {@link DEStateSource}.
 */
public interface SubStepSource extends DEStateSource {

    /**
     * Called after each accepted sub-step, so at least once per step.
     *
     * @param state the state there; n long, to be read only, valid during the call
     * @param time  the time there (s)
     */
    void subStepTaken(double[] state, double time);
}
