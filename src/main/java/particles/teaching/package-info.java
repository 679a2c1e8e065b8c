/**
 * Looks at what students wrote and names the mistake: checks of their own solvers and of their own force laws.
 *
 * <p>A one-step method is not tried out but read off: {@link particles.teaching.Probe} answers the j-th evaluation of the
 * derivative with the j-th unit vector, so that every state which the solver sets afterwards shows how much of each
 * evaluation is in it. What is read off is compared with the tableaux of known methods, and each difference is said in the
 * words of the slides. Methods without a tableau - adaptive, implicit,
 * multistep - are judged by what they do on known motions.
 */
package particles.teaching;
