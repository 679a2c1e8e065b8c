/**
 * Explicit Runge-Kutta methods beyond those that the slides spell out: a tableau of numbers and one loop for all.
 *
 * <p>A method of s stages evaluates the derivative at s points within the step,
 * <pre>
 *   k_i = f(s + h sum_j a_ij k_j, t + c_i h),       s(t + h) = s + h sum_i b_i k_i
 * </pre>
 * and is written as its Butcher tableau: c to the left, a in the middle, b below the line. A further line of weights
 * makes a second result of another order from the same stages; the difference of the two estimates the error. (On the
 * slides k includes the factor h; here, as in most books, it does not.)
 *
 * <p>Reference: E. Hairer, S. P. N&oslash;rsett, G. Wanner, <i>Solving Ordinary Differential Equations I</i>, 2nd ed.,
 * Springer 1993, chapter II.
 */
package deSolvers.rungeKutta;
