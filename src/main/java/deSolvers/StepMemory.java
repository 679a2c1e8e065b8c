package deSolvers;

import java.util.Arrays;

/**
 * Where a solver's last step ended, for solvers that can save work when the next step goes on from there: a history of
 * derivatives, the next sub-step, the last acceleration. What they remember is valid only while source, time, state and
 * deltaT are bit for bit what the last step left.
 */
public final class StepMemory {
    private DEStateSource source;
    private double time;
    private double deltaT;
    private double[] state = {};

    /**
     * Whether a step that begins here continues the last one.
     *
     * @param source the source to be stepped
     * @param time   its time (s)
     * @param state  its state
     * @param deltaT the step to be made (s)
     * @return true if all four are bit for bit what {@link #keep} was told
     */
    public boolean holds(DEStateSource source, double time, double[] state, double deltaT) {
        return source == this.source
                && Double.doubleToLongBits(time) == Double.doubleToLongBits(this.time)
                && Double.doubleToLongBits(deltaT) == Double.doubleToLongBits(this.deltaT)
                && Arrays.equals(state, this.state);
    }

    /**
     * Notes where a step ended.
     *
     * @param source the source that was stepped
     * @param time   its time (s)
     * @param state  its state; copied
     * @param deltaT the step that was made (s)
     */
    public void keep(DEStateSource source, double time, double[] state, double deltaT) {
        if (this.state.length != state.length) {
            this.state = new double[state.length];
        }
        System.arraycopy(state, 0, this.state, 0, state.length);
        this.source = source;
        this.time = time;
        this.deltaT = deltaT;
    }

    /** Forgets the last step; nothing continues it any more. */
    public void forget() {
        source = null;
    }
}
