package deSolvers.problems;

import deSolvers.DESolver;
import deSolvers.SecondOrderStateSource;

/**
 * The 2 x 2 matrix by which a step multiplies the state (x, v) of a linear system.
 *
 * @param xx            the share of x in the new x
 * @param xv            the share of v in the new x
 * @param vx            the share of x in the new v
 * @param vv            the share of v in the new v
 * @param nonlinearity  the deviation of the step from a multiplication by any matrix, as a fraction of the largest
 *                      entry
 */
public record StepMatrix(double xx, double xv, double vx, double vv, double nonlinearity) {

    /**
     * @param solver a solver without memory
     * @param source the system
     * @param steps  the number of steps
     * @param deltaT the time step
     * @param size   the size of the state at its start
     * @return the matrix of all these steps; of one step on the test equation, for a method that treats all entries of
     *         the state alike, it is (a, -b; b, a) with R = a + i b
     */
    public static StepMatrix of(DESolver solver, LinearPair source, int steps, double deltaT, double size) {
        source.start(size);
        source.step(solver, steps, deltaT);
        StepMatrix sized = source.stepMatrix();
        return new StepMatrix(sized.xx / size, sized.xv / size, sized.vx / size, sized.vv / size, sized.nonlinearity);
    }

    /** @return the determinant: the factor by which the step changes areas in state space (1 = symplectic) */
    public double determinant() {
        return xx * vv - xv * vx;
    }

    /** @return the larger modulus of its eigenvalues */
    public double radius() {
        double half = (xx + vv) / 2;
        double discriminant = half * half - determinant();
        return discriminant < 0 ? Math.sqrt(determinant()) : Math.abs(half) + Math.sqrt(discriminant);
    }

    /** @return whether the steps change no state */
    public boolean isIdentity() {
        return xx == 1 && xv == 0 && vx == 0 && vv == 1;
    }

    /** @return the distance from a multiplication of x + i v by one complex number, relative to the largest entry */
    public double distinction() {
        return new StepMatrix(xx, -vx, vx, xx, 0).difference(this);
    }

    /**
     * @param other another matrix
     * @return the largest difference of the entries, relative to the largest entry
     */
    public double difference(StepMatrix other) {
        return largest(xx - other.xx, xv - other.xv, vx - other.vx, vv - other.vv)
                / Math.max(largest(xx, xv, vx, vv), Double.MIN_NORMAL);
    }

    /** @return the largest size of a number; NaN if one of them is not a number */
    static double largest(double... numbers) {
        double largest = 0;
        for (double number : numbers) {
            largest = Math.max(largest, Math.abs(number));
        }
        return largest;
    }

    /**
     * The linear test equation (x, v)' = M (x, v) as a source, in three copies. Their order is (x1, x2, x3, v1, v2,
     * v3), as methods for positions and velocities expect. The first copy starts at (1, 0) and the second at (0, 1), so
     * that one step shows the 2 x 2 matrix by which it multiplies. The third starts at (1, 1); if the step is linear,
     * it ends at the sum of the first two.
     */
    public static class LinearPair extends ReferenceProblem {
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
            double off = largest(state[0] + state[1] - state[2],
                    state[COPIES] + state[COPIES + 1] - state[COPIES + 2]);
            return new StepMatrix(state[0], state[1], state[COPIES], state[COPIES + 1],
                    off / Math.max(size(), Double.MIN_NORMAL));
        }

        /** @return the largest entry */
        public double size() {
            return largest(getState());
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
}
