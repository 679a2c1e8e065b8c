/**
 * Exercises that mark themselves, in the order of the lecture. Each derives its numbers from a student's id, so that a
 * neighbour's result is of no use, and computes the right answer by running the solvers, or by a formula that a test
 * holds against a run. It also computes the wrong answers of typical mistakes, so that it can name the mistake.
 */
package particles.teaching.exercises;
