package deSolvers.implicit;

import deSolvers.linear.LinearWork;

/**
 * Counts of the work of an implicit solver since it was created, besides the derivative calls, which the source counts.
 *
 * @param newtonIterations corrections that Newton's method computed
 * @param jacobians        Jacobians (dense or block by block) that were set up
 * @param products         products of the Jacobian with a direction that the source computed
 * @param krylovIterations iterations of conjugate gradients and GMRES
 * @param factorisations   matrices that were factorised, real and complex ones counted alike
 * @param blockOperations  products of 3 x 3 blocks with blocks or vectors: a measure of the sparse matrices' time that
 *                         does not depend on the machine
 */
public record ImplicitWork(long newtonIterations, long jacobians, long products, long krylovIterations,
                           long factorisations, long blockOperations) {

    /** The same, counting. */
    static final class Counter {
        final LinearWork linear = new LinearWork();
        long newtonIterations;
        long jacobians;
        long products;

        ImplicitWork read() {
            return new ImplicitWork(newtonIterations, jacobians, products, linear.iterations, linear.factorisations,
                    linear.blockOperations);
        }
    }
}
