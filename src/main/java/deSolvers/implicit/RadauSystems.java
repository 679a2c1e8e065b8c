package deSolvers.implicit;

import deSolvers.StepTransaction;

/**
 * The two linear systems into which one of Newton's iterations for the three stages falls apart, with the real
 * eigenvalue and the complex pair of the inverse of the method's matrix: (mu - h J) x = b, real and complex.
 */
interface RadauSystems {

    /**
     * Takes up the Jacobian at a state.
     *
     * @param source the step's source; left anywhere
     * @param state  where
     * @param slope  the derivative there
     * @param offset its time, from the beginning of the step (s)
     * @param h      a sub-step (s), for scale
     */
    void setJacobian(StepTransaction source, double[] state, double[] slope, double offset, double h);

    /** Whether a Jacobian, once taken up, may serve later sub-steps too. */
    boolean keepsJacobian();

    /**
     * Prepares the systems for a sub-step.
     *
     * @return false if one of them is singular
     */
    boolean prepare(double h, double real, double complexRe, double complexIm);

    /** Solves the real system; false if that failed. The arrays are different ones. */
    boolean solveReal(double[] b, double[] x);

    /** Solves the complex system; false if that failed. Real and imaginary parts in turn, in arrays of 2n. */
    boolean solveComplex(double[] b, double[] x);
}
