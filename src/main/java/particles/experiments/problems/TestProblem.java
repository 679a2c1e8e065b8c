package particles.experiments.problems;

import deSolvers.SecondOrderStateSource;
import java.util.Arrays;

/**
 * A motion x'' = a(x, v, t) that a solver is measured on, beginning at t = 0. Counts the evaluations of the derivative.
 */
public abstract class TestProblem implements SecondOrderStateSource {
    private final double[] state;
    private double time;
    private long evaluations;

    /** @param start the state at t = 0: one block, positions and then velocities */
    protected TestProblem(double... start) {
        state = start.clone();
    }

    /**
     * The law of motion.
     *
     * @param s    the state, d positions and d velocities
     * @param dSdt receives the accelerations in its second half; the first is filled already
     */
    protected abstract void accelerate(double[] s, double[] dSdt);

    /** @return how often the derivative was evaluated so far */
    public final long getEvaluations() {
        return evaluations;
    }

    @Override
    public final int getDimension() {
        return state.length / 2;
    }

    @Override
    public boolean accelerationDependsOnVelocity() {
        return false;
    }

    @Override
    public final int getStateSize() {
        return state.length;
    }

    @Override
    public final void getState(double[] s) {
        System.arraycopy(state, 0, s, 0, state.length);
    }

    @Override
    public final void setState(double[] s) {
        System.arraycopy(s, 0, state, 0, state.length);
    }

    @Override
    public final void getStateDerivative(double[] dSdt) {
        evaluations++;
        int d = state.length / 2;
        Arrays.fill(dSdt, 0);
        System.arraycopy(state, d, dSdt, 0, d);
        accelerate(state, dSdt);
    }

    @Override
    public final double getTime() {
        return time;
    }

    @Override
    public final void incTime(double deltaT) {
        time += deltaT;
    }
}
