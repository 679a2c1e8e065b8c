/**
 * Checks a student's solver, and names the mistake.
 *
 * <p>The coefficients of a one-step method are read off: {@link particles.teaching.sources.Probe} answers the j-th
 * evaluation
 * of the derivative with the j-th unit vector, so that every state which the solver sets afterwards shows how much of
 * each
 * evaluation is in it. They are compared with those of known methods, and each difference is said in the words of the
 * slides.
 * Methods without fixed coefficients - adaptive, implicit, multistep - are judged by the order that is measured.
 */
package particles.teaching.solvers;
