package deSolvers.linear;

/**
 * What an implicit solver has done since it was made, beyond the calls of the derivative that the source counts itself.
 *
 * @param newtonIterations corrections that Newton's method computed
 * @param jacobians        Jacobians (dense or block by block) that were set up
 * @param products         products of the Jacobian with a direction that the source computed
 * @param krylovIterations iterations of conjugate gradients and GMRES
 * @param factorisations   matrices that were factorised, real and complex ones counted alike
 * @param blockOperations  products of two 3 x 3 blocks, or of nine entries with three, that the sparse matrices took: a
 *                         deterministic measure of the time spent on them
 */
public record ImplicitWork(long newtonIterations, long jacobians, long products, long krylovIterations,
                           long factorisations, long blockOperations) {

    /** The same, counting. */
    public static final class Counter {
        public long newtonIterations;
        public long jacobians;
        public long products;
        public long krylovIterations;
        public long factorisations;
        public long blockOperations;

        public ImplicitWork read() {
            return new ImplicitWork(newtonIterations, jacobians, products, krylovIterations, factorisations,
                    blockOperations);
        }
    }
}
