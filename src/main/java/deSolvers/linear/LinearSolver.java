package deSolvers.linear;

/** A solver of linear systems A x = b, for the matrix A that it holds. */
public interface LinearSolver {
    /**
     * Solves A x = b. A direct method is exact up to round-off and does not look at the tolerance.
     *
     * @param b         the right-hand side; not changed
     * @param x         receives the solution; another array of the same length
     * @param tolerance iterations stop at |b - A x| &lt;= tolerance |b|
     * @return false if A is singular or not finite, or the iterations did not converge
     */
    boolean solve(double[] b, double[] x, double tolerance);
}
