package particles.teaching;

import deSolvers.SecondOrderStateSource;
import java.util.ArrayList;
import java.util.List;

/**
 * Particles on springs in a field that changes with time: in each coordinate x'' = -4 x + 3 cos t, from x = 1.5 at rest at
 * t = 0. Exact: x = cos t + 0.5 cos 2t. Because the law depends on time, it shows a clock that is wrong within a step.
 */
final class WindyOscillators implements SecondOrderStateSource {
    /** What a source may throw, when it is told to. */
    static final class Failure extends RuntimeException {
        private static final long serialVersionUID = 1L;

        Failure() {
            super("the source fails, as it was told to");
        }
    }

    private final double[] state;
    private double time;
    private int evaluations;
    private int failAt = -1;
    private boolean spoilt;
    private final List<Integer> wrongLengths = new ArrayList<>();

    /** @param particles how many; six numbers each */
    WindyOscillators(int particles) {
        state = new double[6 * particles];
        for (int k = 0; k < state.length; k++) {
            state[k] = k % 6 < 3 ? 1.5 : 0;
        }
    }

    /** @return another one at the same place and time */
    WindyOscillators copy() {
        WindyOscillators copy = new WindyOscillators(state.length / 6);
        copy.setState(state);
        copy.time = time;
        return copy;
    }

    /** @return a copy of the state */
    double[] state() {
        return state.clone();
    }

    /** @return the largest difference of the state from the exact one */
    double error() {
        double x = StrictMath.cos(time) + 0.5 * StrictMath.cos(2 * time);
        double v = -StrictMath.sin(time) - StrictMath.sin(2 * time);
        double error = 0;
        for (int k = 0; k < state.length; k++) {
            double difference = Math.abs(state[k] - (k % 6 < 3 ? x : v));
            error = difference <= error ? error : difference;
        }
        return error;
    }

    /** @return the length of the first array that was not as long as the state, or -1 */
    int wrongLength() {
        return wrongLengths.isEmpty() ? -1 : wrongLengths.get(0);
    }

    int evaluations() {
        return evaluations;
    }

    /** @param evaluation the number of the evaluation, from 0, that is to fail */
    void failAtEvaluation(int evaluation) {
        failAt = evaluation;
    }

    /** From now on the derivative is NaN. */
    void spoilDerivative() {
        spoilt = true;
    }

    @Override
    public int getDimension() {
        return 3;
    }

    @Override
    public boolean accelerationDependsOnVelocity() {
        return false;
    }

    @Override
    public int getStateSize() {
        return state.length;
    }

    private int common(double[] s) {
        if (s.length != state.length) {
            wrongLengths.add(s.length);
        }
        return Math.min(s.length, state.length);
    }

    @Override
    public void getState(double[] s) {
        System.arraycopy(state, 0, s, 0, common(s));
    }

    @Override
    public void setState(double[] s) {
        System.arraycopy(s, 0, state, 0, common(s));
    }

    @Override
    public void getStateDerivative(double[] dSdt) {
        if (evaluations++ == failAt) {
            throw new Failure();
        }
        double field = 3 * StrictMath.cos(time);
        int n = common(dSdt);
        for (int k = 0; k < n; k++) {
            dSdt[k] = spoilt ? Double.NaN : k % 6 < 3 ? state[k + 3] : -4 * state[k - 3] + field;
        }
    }

    @Override
    public double getTime() {
        return time;
    }

    @Override
    public void incTime(double deltaT) {
        time += deltaT;
    }
}
