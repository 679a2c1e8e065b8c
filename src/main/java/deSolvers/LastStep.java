package deSolvers;

import java.util.Arrays;

/**
 * The end of a solver's last step, for methods that use results of earlier steps: a history of derivatives, the next
 * sub-step, the last acceleration. Such results are valid only while source, state and deltaT are bit for bit the same
 * as at the end of the last step, and the time but for the round-off of one addition: a loop may set the clock to a
 * multiple of deltaT.
 */
public final class LastStep {
    private boolean known;
    private DEStateSource source;
    private double time;
    private double[] state = {};
    private double deltaT;

    /**
     * Tells whether a step continues the last one, and forgets the last one in either case.
     *
     * @param step the step that begins
     * @return true if its source, time, state and deltaT are the same as at the end of the last step
     */
    public boolean continuesFrom(StepTransaction step) {
        boolean continues = known && source == step.getClient()
                && Math.abs(time - step.getStartTime()) <= 2 * Math.max(Math.ulp(time), Math.ulp(deltaT))
                && Double.compare(deltaT, step.getDeltaT()) == 0
                && Arrays.equals(state, step.getStartState());
        known = false;
        return continues;
    }

    /**
     * Notes where a step ends.
     *
     * @param step     the step
     * @param newState s(t + deltaT); copied
     */
    public void keep(StepTransaction step, double[] newState) {
        if (state.length != newState.length) {
            state = new double[newState.length];
        }
        System.arraycopy(newState, 0, state, 0, newState.length);
        source = step.getClient();
        time = step.getStartTime() + step.getDeltaT();
        deltaT = step.getDeltaT();
        known = true;
    }

    /** Forgets the last step. */
    public void forget() {
        known = false;
    }
}
