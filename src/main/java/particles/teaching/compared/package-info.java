/**
 * The second step: a solver's steps are compared with those of known methods, and with those that typical mistakes make
 * of them ({@link particles.teaching.compared.Mistake}). A mistake is named if it makes the same steps, to round-off,
 * on two sources, and on a third with drag if its method treats all entries alike.
 */
package particles.teaching.compared;
