/**
 * Solvers that choose their own sub-steps: "many small steps should tiptoe through treacherous terrain, while a few great
 * strides should speed through smooth uninteresting countryside" (the slides, after Numerical Recipes).
 *
 * <p>{@link deSolvers.adaptive.AdaptiveSolver} covers deltaT by sub-steps for all of them; a method says what one
 * sub-step gives and how far off it probably is. A sub-step is taken when the estimated error of every entry of the state
 * is at most absoluteTolerance + relativeTolerance times the entry. That is the error of one sub-step: the error at the
 * end of a run is roughly proportional to it, with a factor that depends on the problem.
 *
 * <p>Reference: E. Hairer, S. P. N&oslash;rsett, G. Wanner, <i>Solving Ordinary Differential Equations I</i>, 2nd ed.,
 * Springer 1993, section II.4.
 */
package deSolvers.adaptive;
