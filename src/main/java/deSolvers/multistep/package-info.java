/**
 * Multistep methods: they use the derivatives of earlier steps instead of asking for more within a step.
 *
 * <p>Cheap and accurate while the motion is smooth, deltaT stays the same and nobody else touches the state; whatever
 * interrupts them costs a new start.
 *
 * <p>Reference: E. Hairer, S. P. N&oslash;rsett, G. Wanner, <i>Solving Ordinary Differential Equations I</i>, 2nd ed.,
 * Springer 1993, chapter III.
 */
package deSolvers.multistep;
