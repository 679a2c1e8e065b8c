package deSolvers;

import java.util.Arrays;

/**
 * Where a solver's last step ended, for solvers that can save work when the next step goes on from there: a history of
 * derivatives, the next sub-step, the last acceleration. What they remember is valid only while source, time, state and
 * deltaT are bit for bit what the last step left.
 */
public final class StepMemory {
    /** Below this many doubles a plain loop is done before a call of the library has begun. */
    private static final int FEW = 16;

    private boolean valid;
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
        return valid && source == this.source
                && Double.doubleToRawLongBits(time) == Double.doubleToRawLongBits(this.time)
                && Double.doubleToRawLongBits(deltaT) == Double.doubleToRawLongBits(this.deltaT)
                && isKept(state, source.getStateSize());
    }

    /** The source is asked for n, because the loop is none where that is a constant; from the end, for one check of bounds. */
    private boolean isKept(double[] state, int n) {
        double[] kept = this.state;
        if (n != state.length || n != kept.length || n >= FEW) {
            return Arrays.equals(state, kept);
        }
        for (int i = n - 1; i >= 0; i--) {
            if (Double.doubleToRawLongBits(state[i]) != Double.doubleToRawLongBits(kept[i])) {
                return false;
            }
        }
        return true;
    }

    /**
     * Notes where a step ended.
     *
     * @param source the source that was stepped
     * @param time   its time (s)
     * @param state  its state, in an array of the solver's own; not copied, so it has to stay as it is until the next step
     *               asks for it or all is forgotten
     * @param deltaT the step that was made (s)
     */
    public void keep(DEStateSource source, double time, double[] state, double deltaT) {
        if (this.state != state) {                      // storing a reference, even the same, may cost as much as a small step
            this.state = state;
        }
        if (this.source != source) {
            this.source = source;
        }
        valid = true;
        this.time = time;
        this.deltaT = deltaT;
    }

    /** Forgets the last step; nothing continues it any more. */
    public void forget() {
        valid = false;
    }
}
