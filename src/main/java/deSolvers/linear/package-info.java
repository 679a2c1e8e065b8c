/**
 * Large linear systems of implicit methods: a matrix of 3 x 3 blocks on the pattern of a particle system's forces, the
 * iterations that solve it, and its factors.
 *
 * <p>{@link deSolvers.linear.ConjugateGradients} solves symmetric positive definite systems,
 * {@link deSolvers.linear.Gmres} all others, both preconditioned by the inverted diagonal blocks. Systems that are too
 * stiff for iterations are factorised by the multifrontal method in an order found by nested dissection.
 */
package deSolvers.linear;
