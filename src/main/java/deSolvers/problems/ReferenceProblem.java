package deSolvers.problems;

import deSolvers.DESolver;
import deSolvers.DEStateSource;

/**
 * An initial value problem as a state source: state, clock, a count of evaluations and, if known, the exact solution.
 * It refuses arrays that are not exactly as long as the state.
 */
public abstract class ReferenceProblem implements DEStateSource {
    private final double[] start;
    private final double[] state;
    private double time;
    private long evaluations;

    /** @param start the state at t = 0; a copy is taken */
    protected ReferenceProblem(double... start) {
        this(0, start);
    }

    /**
     * @param time  the clock at the start (s)
     * @param start the state at that time; a copy is taken
     */
    protected ReferenceProblem(double time, double[] start) {
        this.time = time;
        this.start = start.clone();
        state = start.clone();
    }

    /**
     * Computes the right-hand side f(s, t).
     *
     * @param t    the time (s)
     * @param s    the state; to be read only
     * @param dSdt receives the derivative
     */
    protected abstract void rates(double t, double[] s, double[] dSdt);

    /**
     * Returns the exact solution. A problem without a known solution has only its start, at t = 0.
     *
     * @param t the time (s)
     * @return the state at that time; a new array
     */
    public double[] exactState(double t) {
        if (t != 0) {
            throw new UnsupportedOperationException("the exact solution is not known at t = " + t);
        }
        return start.clone();
    }

    /**
     * Moves to the exact solution at a time and sets the count of evaluations to 0.
     *
     * @param t the time (s)
     */
    public final void startAt(double t) {
        time = t;
        evaluations = 0;
        System.arraycopy(exactState(t), 0, state, 0, state.length);
    }

    /** Lets a solver make a step of this length (s). */
    public void step(DESolver solver, double deltaT) {
        solver.stepState(this, deltaT);
    }

    /** Lets a solver make steps of this length (s). */
    public final void step(DESolver solver, int steps, double deltaT) {
        for (int n = 0; n < steps; n++) {
            step(solver, deltaT);
        }
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

    /** @return the number of evaluations of the derivative since the start or the last {@link #startAt} */
    public final long getEvaluations() {
        return evaluations;
    }

    /** @return a copy of the state */
    public final double[] getState() {
        return state.clone();
    }

    /**
     * Called with every array that a solver hands over.
     *
     * @param array the solver's array
     * @return the number of its entries to use
     * @throws IllegalArgumentException unless it is exactly as long as the state
     */
    protected int checkLength(double[] array) {
        if (array.length != state.length) {
            throw new IllegalArgumentException("an array of " + array.length + " for a state of " + state.length);
        }
        return array.length;
    }

    @Override
    public final int getStateSize() {
        return state.length;
    }

    @Override
    public void getState(double[] copy) {
        System.arraycopy(state, 0, copy, 0, checkLength(copy));
    }

    @Override
    public void setState(double[] newState) {
        System.arraycopy(newState, 0, state, 0, checkLength(newState));
    }

    @Override
    public void getStateDerivative(double[] dSdt) {
        checkLength(dSdt);
        evaluations++;
        rates(time, state, dSdt);
    }

    @Override
    public final double getTime() {
        return time;
    }

    @Override
    public void incTime(double deltaT) {
        time += deltaT;
    }
}
