/**
 * Solvers that choose their own sub-steps: "many small steps should tiptoe through treacherous terrain, while a few
 * great strides should speed through smooth uninteresting countryside" (the slides, after Numerical Recipes).
 *
 * <p>{@link deSolvers.adaptive.AdaptiveSolver} covers deltaT by sub-steps for all of them; each method implements one
 * sub-step and its error estimate. A sub-step is accepted if the estimated error of every entry s<sub>i</sub> of the
 * state is at most
 * <pre>
 *   absoluteTolerance + relativeTolerance max(|s_i before|, |s_i after|)
 * </pre>
 * This limits the error of one sub-step. The error at the end of a run is roughly proportional to the tolerances; the
 * factor depends on the problem.
 *
 * <p>Only the error estimate keeps an explicit method stable. When a fast component of the solution has decayed, the
 * estimate no longer sees it, and the sub-steps grow beyond the stability limit. The component then grows again, until
 * the estimate notices it and the sub-step is cut. In our tests it reached up to 19 times its tolerance with {@code
 * dormand-prince}, 25 with {@code bulirsch-stoer} and 150 with {@code step-doubling}. At some step lengths an estimate
 * is 0 by chance although the error is large; the last two solvers therefore make two estimates each.
 *
 * <p>The tolerance grows with the entry. With a relative tolerance of 0.1, a vibration that is too fast for the method
 * could grow by a tenth in every sub-step, without end. The largest one accepted is therefore {@value
 * deSolvers.adaptive.AdaptiveSolver#LOOSEST_TOLERANCE}, as SUNDIALS also advises (A. C. Hindmarsh and others, <i>User
 * documentation for CVODE</i>, "General advice on choice of tolerances"). An undamped vibration over hundreds of
 * periods needs a smaller one.
 *
 * <p>Reference: E. Hairer, S. P. N&oslash;rsett, G. Wanner, <i>Solving Ordinary Differential Equations I</i>, 2nd ed.,
 * Springer 1993, section II.4.
 */
package deSolvers.adaptive;
