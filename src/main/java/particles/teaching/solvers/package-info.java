/**
 * Checks of a student's solver, in three steps. What it is meant to be is declared ({@link
 * particles.teaching.solvers.Method}). Its steps are compared with those of known methods, and with those that typical
 * mistakes make of them ({@link particles.teaching.solvers.Mistake}): a mistake is named if it makes the same steps, to
 * round-off, on two sources. What cannot be compared is measured: motions that every method makes exactly, the order on
 * three sources, stability, step-size control.
 */
package particles.teaching.solvers;
