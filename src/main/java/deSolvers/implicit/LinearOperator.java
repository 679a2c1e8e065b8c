package deSolvers.implicit;

/** A linear map that can only be applied: a matrix, a Jacobian by products, or a preconditioner. */
interface LinearOperator {
    /** Computes y from x, another array of the same length. */
    void apply(double[] x, double[] y);
}
