package deSolvers.linear;

/** Counters of the work of linear solvers; they only grow. */
public final class LinearWork {
    /** Iterations of conjugate gradients and GMRES. */
    public long iterations;
    /** Matrices that were factorised, real and complex ones counted alike. */
    public long factorisations;
    /** Products of 3 x 3 blocks with blocks or vectors: a measure of time that does not depend on the machine. */
    public long blockOperations;
}
