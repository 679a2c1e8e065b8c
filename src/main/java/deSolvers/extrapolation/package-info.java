/**
 * Extrapolation: the same stretch is covered several times by a simple method with ever more substeps, and the results
 * are extrapolated to substeps of length 0.
 *
 * <p>The simple method is Gragg's modified midpoint method, whose error is a series in even powers of the substep, so
 * that every further result adds two orders. How many results, and over what stretch, is chosen so that the work for a
 * unit of time is least.
 *
 * <p>Reference: E. Hairer, S. P. N&oslash;rsett, G. Wanner, <i>Solving Ordinary Differential Equations I</i>, 2nd ed.,
 * Springer 1993, section II.9.
 */
package deSolvers.extrapolation;
