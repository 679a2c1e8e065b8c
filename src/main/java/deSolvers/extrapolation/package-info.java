/**
 * Extrapolation methods: a simple method covers the same stretch several times with ever more substeps, and the results
 * are extrapolated to substeps of length 0.
 *
 * <p>The simple method is Gragg's modified midpoint method, whose error is a series in even powers of the substep, so
 * that every further result adds two orders. The number of results and the stretch are chosen for the least work per
 * unit of time.
 *
 * <p>Reference: E. Hairer, S. P. N&oslash;rsett, G. Wanner, <i>Solving Ordinary Differential Equations I</i>, 2nd ed.,
 * Springer 1993, section II.9.
 */
package deSolvers.extrapolation;
