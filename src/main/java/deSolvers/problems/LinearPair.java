package deSolvers.problems;

import deSolvers.SecondOrderStateSource;

/**
 * The linear test equation (x, v)' = M (x, v) as a source, in three copies. Their order is (x1, x2, x3, v1, v2, v3), as
 * methods for positions and velocities expect. The first copy starts at (1, 0) and the second at (0, 1), so that one
 * step shows the 2 x 2 matrix by which it multiplies. The third starts at (1, 1); if the step is linear, it ends at the
 * sum of the first two.
 */
public class LinearPair extends ReferenceProblem {
    private static final int COPIES = 3;
    private final double[] matrix;

    private LinearPair(double... matrix) {
        super(new double[2 * COPIES]);
        this.matrix = matrix;
    }

    /**
     * @param re real part of lambda (1/s)
     * @param im its imaginary part (1/s)
     * @return the test equation y' = (re + i im) y, with the real part of y as x and the imaginary one as v
     */
    public static LinearPair testEquation(double re, double im) {
        return new LinearPair(re, -im, im, re);
    }

    /**
     * @param stiffness omega&sup2; (1/s&sup2;)
     * @param damping   c (1/s)
     * @return x'' = -omega&sup2; x - c x', for the methods that need positions and velocities
     */
    public static LinearPair spring(double stiffness, double damping) {
        return new Spring(stiffness, damping);
    }

    /** @param size the length of the unit vectors at which the copies start */
    public void start(double size) {
        setState(new double[] {size, 0, size, 0, size, size});
        incTime(-getTime());
    }

    /** @return the matrix that multiplied a start of size 1 */
    public StepMatrix stepMatrix() {
        double[] state = getState();
        double off = StepMatrix.largest(state[0] + state[1] - state[2],
                state[COPIES] + state[COPIES + 1] - state[COPIES + 2]);
        return new StepMatrix(state[0], state[1], state[COPIES], state[COPIES + 1],
                off / Math.max(size(), Double.MIN_NORMAL));
    }

    /** @return the largest entry */
    public double size() {
        return StepMatrix.largest(getState());
    }

    /** Accepts longer arrays: other sources check how a solver treats arrays. */
    @Override
    protected int checkLength(double[] array) {
        return 2 * COPIES;
    }

    @Override
    protected void rates(double t, double[] s, double[] dSdt) {
        for (int k = 0; k < COPIES; k++) {
            dSdt[k] = matrix[0] * s[k] + matrix[1] * s[k + COPIES];
            dSdt[k + COPIES] = matrix[2] * s[k] + matrix[3] * s[k + COPIES];
        }
    }

    /** A damped spring in each of three directions. */
    private static final class Spring extends LinearPair implements SecondOrderStateSource {
        private final boolean damped;

        Spring(double stiffness, double damping) {
            super(0, 1, -stiffness, -damping);
            damped = damping != 0;
        }

        @Override
        public int getDimension() {
            return 3;
        }

        @Override
        public boolean accelerationDependsOnVelocity() {
            return damped;
        }
    }
}
