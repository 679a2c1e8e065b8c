package deSolvers.linear;

/** A linear map that can only be applied: a matrix, a Jacobian by products, or a preconditioner. */
public interface LinearOperator {
    /** What stands for a preconditioner where there is none. */
    LinearOperator IDENTITY = (x, y) -> System.arraycopy(x, 0, y, 0, x.length);

    /** Computes y from x, another array of the same length. */
    void apply(double[] x, double[] y);
}
