package deSolvers.problems;

import deSolvers.DEStateSource;

/**
 * An initial value problem whose exact solution is known: the source to be stepped, the state to compare with, and a
 * count of the derivative's evaluations. Refuses arrays that are not exactly as long as the state.
 */
public abstract class ReferenceProblem implements DEStateSource {
    private final double[] state;
    private double time;
    private long evaluations;

    /** @param n the state's size */
    protected ReferenceProblem(int n) {
        state = new double[n];
    }

    /**
     * @param t the time (s)
     * @return the exact solution there; a new array
     */
    public abstract double[] exactState(double t);

    /**
     * The right-hand side f(s, t).
     *
     * @param t    the time (s)
     * @param s    the state
     * @param dSdt receives the derivative
     */
    protected abstract void rates(double t, double[] s, double[] dSdt);

    /**
     * Puts the cursor on the exact solution and the count of evaluations to 0.
     *
     * @param t the time (s)
     */
    public final void startAt(double t) {
        time = t;
        evaluations = 0;
        System.arraycopy(exactState(t), 0, state, 0, state.length);
    }

    /** @return the largest deviation of an entry from the exact solution at the present time */
    public final double error() {
        double[] exact = exactState(time);
        double error = 0;
        for (int i = 0; i < exact.length; i++) {
            error = Math.max(error, Math.abs(state[i] - exact[i]));
        }
        return error;
    }

    /** @return how often the derivative was evaluated since {@link #startAt} */
    public final long evaluations() {
        return evaluations;
    }

    /** @return a copy of the state */
    public final double[] state() {
        return state.clone();
    }

    @Override
    public final int getStateSize() {
        return state.length;
    }

    @Override
    public final void getState(double[] copy) {
        checkLength(copy);
        System.arraycopy(state, 0, copy, 0, state.length);
    }

    @Override
    public final void setState(double[] newState) {
        checkLength(newState);
        System.arraycopy(newState, 0, state, 0, state.length);
    }

    @Override
    public final void getStateDerivative(double[] dSdt) {
        checkLength(dSdt);
        evaluations++;
        rates(time, state, dSdt);
    }

    @Override
    public final double getTime() {
        return time;
    }

    @Override
    public final void incTime(double deltaT) {
        time += deltaT;
    }

    private void checkLength(double[] array) {
        if (array.length != state.length) {
            throw new IllegalArgumentException("an array of " + array.length + " for a state of " + state.length);
        }
    }
}
