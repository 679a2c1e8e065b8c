/**
 * Checks of a student's solver, which name the mistake.
 *
 * <p>The check reads the coefficients of a one-step method from one step. {@link particles.teaching.sources.Probe} is a
 * made-up source whose j-th derivative is the j-th unit vector. Each state that the solver sets is then a list of
 * coefficients: its entry j is the weight of the j-th evaluation. The check compares the coefficients with those of
 * known methods, and describes each difference in the words of the slides. Methods without fixed coefficients -
 * adaptive, implicit, multistep - are judged by the equations that they solve, the weights of later steps, their
 * measured order, and the accuracy that they keep.
 */
package particles.teaching.solvers;
