/**
 * Solvers that choose their own sub-steps: "many small steps should tiptoe through treacherous terrain, while a few
 * great strides should speed through smooth uninteresting countryside" (the slides, after Numerical Recipes).
 *
 * <p>{@link deSolvers.adaptive.AdaptiveSolver} covers deltaT by sub-steps for all of them; each method implements one
 * sub-step and its error estimate. A sub-step is taken when the estimated error of every entry of the state is at most
 * absoluteTolerance + relativeTolerance times the entry. That is the error of one sub-step: the error at the end of a
 * run is roughly proportional to it, with a factor that depends on the problem.
 *
 * <p>The error estimate is all that protects an explicit method from parts of a solution that are too fast for it:
 * once they have decayed, the sub-steps grow until they return. {@code step-doubling} and {@code bulirsch-stoer}
 * therefore make two estimates, since each alone is 0 by chance at some lengths. The worst error is 77 times the
 * estimate, so a decayed part may return to many times its tolerance, but no further. The tolerance is relative to the
 * larger of the entries before and after the sub-step, so a relative tolerance of 0.1 lets a vibration that is too
 * fast for the method grow by a tenth in every sub-step. So no relativeTolerance over {@value
 * deSolvers.adaptive.AdaptiveSolver#LOOSEST_TOLERANCE} is accepted, which is also the advice of SUNDIALS (A. C.
 * Hindmarsh and others, <i>User documentation for CVODE</i>, "General advice on choice of tolerances"); an undamped
 * vibration over hundreds of periods needs less than that.
 *
 * <p>Reference: E. Hairer, S. P. N&oslash;rsett, G. Wanner, <i>Solving Ordinary Differential Equations I</i>, 2nd ed.,
 * Springer 1993, section II.4.
 */
package deSolvers.adaptive;
