package deSolvers;

import java.util.Arrays;

/**
 * Where a solver's last step ended, for solvers that can save work when the next step goes on from there: a history of
 * derivatives, the next sub-step, the last acceleration. What they remember is valid only while source, time, state and
 * deltaT are bit for bit what the last step left.
 */
public final class StepMemory {
    private boolean valid;
    private DEStateSource source;
    private double time;
    private double deltaT;

    /**
     * Whether a step that begins here continues the last one. Whichever it is, the last one is forgotten with this call: the
     * step that begins is remembered when it has ended well.
     *
     * @param source the source to be stepped
     * @param time   its time (s)
     * @param state  its state
     * @param deltaT the step to be made (s)
     * @param left   the state that the last step left, as the solver has it in an array of its own
     * @return true if the two states are bit for bit the same, and the others are what {@link #keep} was told
     */
    public boolean takeUp(DEStateSource source, double time, double[] state, double deltaT, double[] left) {
        boolean held = valid;
        valid = false;
        return held && source == this.source
                && Double.doubleToRawLongBits(time) == Double.doubleToRawLongBits(this.time)
                && Double.doubleToRawLongBits(deltaT) == Double.doubleToRawLongBits(this.deltaT)
                && areSame(state, left);
    }

    private static boolean areSame(double[] a, double[] b) {
        if (a.length == 2 && b.length == 2) {           // the slides' oscillator: a call of the library costs a third of its step
            return Double.doubleToRawLongBits(a[0]) == Double.doubleToRawLongBits(b[0])
                    && Double.doubleToRawLongBits(a[1]) == Double.doubleToRawLongBits(b[1]);
        }
        return Arrays.equals(a, b);
    }

    /**
     * Notes where a step ended; the solver keeps the state.
     *
     * @param source the source that was stepped
     * @param time   its time (s)
     * @param deltaT the step that was made (s)
     */
    public void keep(DEStateSource source, double time, double deltaT) {
        if (this.source != source) {                    // storing a reference, even the same, may cost as much as a small step
            this.source = source;
        }
        this.time = time;
        this.deltaT = deltaT;
        valid = true;
    }

    /** Forgets the last step; nothing continues it any more. */
    public void forget() {
        valid = false;
    }
}
