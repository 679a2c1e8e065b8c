package deSolvers;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;

import deSolvers.problems.Oscillator;
import org.hipparchus.complex.Complex;

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
        Complex r = at(h, numerator).divide(at(h, denominator));
        return new double[] {r.getReal(), r.getImaginary(), -r.getImaginary(), r.getReal()};
    }

    /** The product of two matrices. */
    public static double[] product(double[] a, double[] b) {
        return new double[] {a[0] * b[0] + a[1] * b[2], a[0] * b[1] + a[1] * b[3],
            a[2] * b[0] + a[3] * b[2], a[2] * b[1] + a[3] * b[3]};
    }

    /** Asserts that a step of x'' = -x is a multiplication by a matrix. */
    public static void assertStep(DESolver solver, double h, double[] closed) {
        for (int column = 0; column < 2; column++) {
            Oscillator problem = new Oscillator(1, 1 - column, column);
            solver.reset();
            solver.stepState(problem, h);
            assertArrayEquals(new double[] {closed[column], closed[2 + column]}, problem.getState(), 1e-12,
                    "column " + column + " at h = " + h);
        }
    }

    /** A polynomial at z = ih, by Horner's rule. */
    private static Complex at(double h, double[] coefficients) {
        Complex sum = Complex.ZERO;
        for (int i = coefficients.length - 1; i >= 0; i--) {
            sum = sum.multiply(new Complex(0, h)).add(coefficients[i]);
        }
        return sum;
    }
}
