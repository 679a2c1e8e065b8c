package deSolvers;

/**
 * What a solver adds that can tell the states between the ends of its last step, so that frames at regular times and the
 * times of collisions need no short steps. Switched off to begin with: keeping the pieces costs memory, one polynomial
 * for each sub-step. The trajectory has the same bits with and without.
 */
public interface DenseOutput {

    /**
     * Switches the keeping of the states in between on or off, from the next step on.
     *
     * @param on whether to keep them
     */
    void setDenseOutput(boolean on);

    /**
     * The state at a time within the last step, about as accurate as the step's tolerance asks. That may be less than the
     * step itself reaches: within the tolerance, {@code radau} was up to 130 times as far off between the ends as at them.
     * Costs no evaluation, needs no source and moves none. A step of no length changes nothing here either.
     *
     * @param time  a time from the beginning to the end of the last step, both included (s)
     * @param state receives the state; as long as the last source's
     * @throws IllegalStateException    if there is no last step: none was made with dense output on since the solver was
     *                                  made or reset, or the last one failed
     * @throws IllegalArgumentException if the time lies outside the last step or the array has another length
     */
    void getStateAt(double time, double[] state);
}
