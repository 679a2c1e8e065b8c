/**
 * Multistep methods: they use the derivatives of earlier steps instead of more evaluations within a step.
 *
 * <p>They are cheap and accurate while the motion is smooth, deltaT stays the same and nothing else changes the state;
 * every interruption needs a restart.
 *
 * <p>Reference: E. Hairer, S. P. N&oslash;rsett, G. Wanner, <i>Solving Ordinary Differential Equations I</i>, 2nd ed.,
 * Springer 1993, chapter III.
 */
package deSolvers.multistep;
