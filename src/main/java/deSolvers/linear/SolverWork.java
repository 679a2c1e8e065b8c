package deSolvers.linear;

/**
 * Counters of the work of an implicit solver and of its linear systems, besides the derivative calls, which the source
 * counts. They only grow.
 */
public final class SolverWork {
    /** Corrections that Newton's method computed. */
    public long newtonIterations;
    /** Jacobians (dense or block by block) that were set up. */
    public long jacobians;
    /** Products of the Jacobian with a direction, by a difference of two evaluations of which one is known. */
    public long products;
    /** Iterations of conjugate gradients and GMRES. */
    public long iterations;
    /** Matrices that were factorised, real and complex ones counted alike. */
    public long factorisations;
    /** Products of 3 x 3 blocks with blocks or vectors: a measure of time that does not depend on the machine. */
    public long blockOperations;
}
