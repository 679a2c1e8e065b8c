package particles.experiments;

import deSolvers.DEStateSource;

/**
 * Two linear equations (x, v)' = M (x, v) as a source, three times over in the order (x1, x2, x3, v1, v2, v3) that methods
 * for positions and velocities expect. The first copy starts at (1, 0) and the second at (0, 1), so that one step shows the
 * 2 x 2 matrix by which it multiplies; the third starts at (1, 1) and ends at the sum of the two, if the step is linear.
 */
class LinearPair implements DEStateSource {
    private static final int COPIES = 3;
    private final double[] matrix;
    private final double[] state = new double[2 * COPIES];
    private double time;
    private long evaluations;

    LinearPair(double... matrix) {
        this.matrix = matrix;
    }

    /** @return the test equation y' = (re + i im) y, with the real part of y as x and the imaginary one as v */
    static LinearPair testEquation(double re, double im) {
        return new LinearPair(re, -im, im, re);
    }

    /**
     * @param stiffness omega&sup2; (1/s&sup2;)
     * @param damping   c (1/s)
     * @return x'' = -omega&sup2; x - c x', for the methods that need positions and velocities
     */
    static LinearPair spring(double stiffness, double damping) {
        return new LinearSpring(stiffness, damping);
    }

    /** @param size of the unit vectors at which the copies start */
    void start(double size) {
        double[] x = {size, 0, size, 0, size, size};
        System.arraycopy(x, 0, state, 0, x.length);
        time = 0;
    }

    /** @return the matrix that multiplied the start, row by row, for a start of size 1 */
    double[] product() {
        return new double[] {state[0], state[1], state[COPIES], state[COPIES + 1]};
    }

    /** @return by how much the third copy is not the sum of the two others, relative to the largest entry; 0 if all are 0 */
    double nonlinearity() {
        double largest = Math.max(size(), Double.MIN_NORMAL);
        return Math.max(Math.abs(state[0] + state[1] - state[2]),
                Math.abs(state[COPIES] + state[COPIES + 1] - state[COPIES + 2])) / largest;
    }

    /** @return the largest entry */
    double size() {
        double largest = 0;
        for (double entry : state) {
            largest = Math.abs(entry) <= largest ? largest : Math.abs(entry);       // NaN stays
        }
        return largest;
    }

    /** @return how often the derivative was asked for */
    long evaluations() {
        return evaluations;
    }

    double damping() {
        return -matrix[3];
    }

    @Override
    public int getStateSize() {
        return state.length;
    }

    @Override
    public void getState(double[] copy) {
        System.arraycopy(state, 0, copy, 0, state.length);
    }

    @Override
    public void setState(double[] newState) {
        System.arraycopy(newState, 0, state, 0, state.length);
    }

    @Override
    public void getStateDerivative(double[] dSdt) {
        evaluations++;
        for (int k = 0; k < COPIES; k++) {
            dSdt[k] = matrix[0] * state[k] + matrix[1] * state[k + COPIES];
            dSdt[k + COPIES] = matrix[2] * state[k] + matrix[3] * state[k + COPIES];
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
