/**
 * Linear systems A x = b, of implicit solvers and of constraint forces. {@link deSolvers.linear.BlockSolver} serves
 * implicit solvers: their sparse matrix has 3 x 3 blocks, one for each pair of particles that act on each other. It is
 * solved by conjugate gradients where it is symmetric positive definite, by GMRES otherwise, both preconditioned by the
 * inverses of its diagonal blocks; an ill-conditioned matrix is factorised. EJML solves the systems with a full matrix.
 *
 * <p>The matrix of constraint forces has one entry, not a block, for each pair of rods or contacts that share a
 * particle, and its rows come and go with contacts. {@link deSolvers.linear.EnvelopeMatrix} factorises its active rows;
 * entries lie near the diagonal, so there is no fill-in beyond the envelope. {@link
 * deSolvers.linear.MinimumNormSolution} serves where rows are dependent.
 *
 * <h2>The sparse factorisation</h2>
 * Eliminating a row of a sparse matrix makes new entries, the <i>fill-in</i>: all later rows that it touches then touch
 * each other. Its size depends on the order. {@code NestedDissection} cuts the graph of the matrix, whose edges are the
 * springs, by a small set of rows, a <i>separator</i>, and puts the separator last; the parts on its two sides never
 * touch each other, and are ordered in the same way. In a cloth of n particles this leaves about n log n entries. The
 * <i>elimination tree</i> says which row contributes to which: the parent of a row is the first later row that it
 * touches. {@code BlockFactors} finds the fill-in from it before it computes, once for each pattern of springs.
 *
 * <p>References: Y. Saad, <i>Iterative Methods for Sparse Linear Systems</i>, 2nd ed., SIAM 2003; T. A. Davis,
 * <i>Direct Methods for Sparse Linear Systems</i>, SIAM 2006.
 */
package deSolvers.linear;
