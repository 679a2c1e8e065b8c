package deSolvers.problems;

import deSolvers.DESolver;

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
}
