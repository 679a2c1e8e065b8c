package deSolvers.linear;

/**
 * A linear map that can be applied to a vector: a matrix, a Jacobian known only by its products, or a preconditioner.
 */
public interface LinearOperator {
    /**
     * Applies the map.
     *
     * @param x a vector
     * @param y receives the image of x; another array of the same length
     */
    void apply(double[] x, double[] y);
}
