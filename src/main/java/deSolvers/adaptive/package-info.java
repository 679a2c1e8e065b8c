/**
 * Solvers that choose their own sub-steps: "many small steps should tiptoe through treacherous terrain, while a few
 * great strides should speed through smooth uninteresting countryside" (the slides, after Numerical Recipes).
 *
 * <p>{@link deSolvers.adaptive.AdaptiveSolver} covers deltaT by sub-steps for all of them; a method says what one
 * sub-step gives and how far off it probably is. A sub-step is taken when the estimated error of every entry of the
 * state is at most absoluteTolerance + relativeTolerance times the entry. That is the error of one sub-step: the error
 * at the end of a run is roughly proportional to it, with a factor that depends on the problem.
 *
 * <p>The estimate is the only guard of an explicit method against parts of a solution that are too fast for it: what
 * has decayed lets the sub-steps grow until it comes back. {@code step-doubling} and {@code bulirsch-stoer} therefore
 * make two estimates, since each alone is 0 by chance at some lengths. The worst error is 77 times the estimate, so
 * that what has decayed comes back to many times its tolerance, but no further. And since the entry is the one after
 * the sub-step, or the one before where that is larger, a tolerance of a tenth lets a vibration that the method cannot
 * follow grow by a tenth in every sub-step, and never objects. So no relativeTolerance over
 * {@value deSolvers.adaptive.AdaptiveSolver#LOOSEST_TOLERANCE} is accepted, which is also the advice of SUNDIALS (A. C.
 * Hindmarsh and others, <i>User documentation for CVODE</i>, "General advice on choice of tolerances"); an undamped
 * vibration over hundreds of periods needs less than that.
 *
 * <p>Reference: E. Hairer, S. P. N&oslash;rsett, G. Wanner, <i>Solving Ordinary Differential Equations I</i>, 2nd ed.,
 * Springer 1993, section II.4.
 */
package deSolvers.adaptive;
