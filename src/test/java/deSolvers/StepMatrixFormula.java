package deSolvers;

/**
 * The matrix of one step for x'' = -x, from a method's stability function R: with A = (0 1; -1 0), whose eigenvalues
 * are +-i, it is R(hA) = Re R(ih) I + Im R(ih) A.
 */
public final class StepMatrixFormula {
    private StepMatrixFormula() {
    }

    /**
     * @param h            the step
     * @param coefficients of 1, z, z^2, ... in R(z)
     * @return the four entries, row by row
     */
    public static double[] polynomial(double h, double... coefficients) {
        return rational(h, coefficients, new double[] {1});
    }

    /**
     * @param h           the step
     * @param numerator   coefficients of 1, z, z^2, ...
     * @param denominator coefficients of 1, z, z^2, ...
     * @return the four entries, row by row
     */
    public static double[] rational(double h, double[] numerator, double[] denominator) {
        double[] p = at(h, numerator);
        double[] q = at(h, denominator);
        double norm = q[0] * q[0] + q[1] * q[1];
        double re = (p[0] * q[0] + p[1] * q[1]) / norm;
        double im = (p[1] * q[0] - p[0] * q[1]) / norm;
        return new double[] {re, im, -im, re};
    }

    /** A polynomial at z = ih, by Horner's rule: real and imaginary part. */
    private static double[] at(double h, double[] coefficients) {
        double re = 0;
        double im = 0;
        for (int i = coefficients.length - 1; i >= 0; i--) {
            double re1 = coefficients[i] - h * im;
            im = h * re;
            re = re1;
        }
        return new double[] {re, im};
    }
}
