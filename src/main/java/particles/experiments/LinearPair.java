package particles.experiments;

import deSolvers.SecondOrderStateSource;

/**
 * Two linear equations s' = M s as a source: the test equation y' = lambda y with the real and the imaginary part of y as
 * its state, or one damped spring for the methods that need positions and velocities.
 */
final class LinearPair implements SecondOrderStateSource {
    private final double[] matrix;
    private final double[] state = new double[2];
    private double time;

    private LinearPair(double... matrix) {
        this.matrix = matrix;
    }

    /** @return y' = (re + i im) y */
    static LinearPair testEquation(double re, double im) {
        return new LinearPair(re, -im, im, re);
    }

    /**
     * @param stiffness omega&sup2; (1/s&sup2;)
     * @param damping   c (1/s)
     * @return x'' = -omega&sup2; x - c x'
     */
    static LinearPair spring(double stiffness, double damping) {
        return new LinearPair(0, 1, -stiffness, -damping);
    }

    void start(double first, double second) {
        state[0] = first;
        state[1] = second;
        time = 0;
    }

    double first() {
        return state[0];
    }

    double second() {
        return state[1];
    }

    @Override
    public int getStateSize() {
        return 2;
    }

    @Override
    public void getState(double[] copy) {
        copy[0] = state[0];
        copy[1] = state[1];
    }

    @Override
    public void setState(double[] newState) {
        state[0] = newState[0];
        state[1] = newState[1];
    }

    @Override
    public void getStateDerivative(double[] dSdt) {
        dSdt[0] = matrix[0] * state[0] + matrix[1] * state[1];
        dSdt[1] = matrix[2] * state[0] + matrix[3] * state[1];
    }

    @Override
    public double getTime() {
        return time;
    }

    @Override
    public void incTime(double deltaT) {
        time += deltaT;
    }

    @Override
    public int getDimension() {
        return 1;
    }

    @Override
    public boolean accelerationDependsOnVelocity() {
        return matrix[3] != 0;
    }
}
