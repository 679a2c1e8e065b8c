/**
 * Exercises that mark themselves, in the order of the lecture. Each draws its numbers from a student's id, so that a
 * neighbour's result is of no use, and computes the right answer by running the solvers; wrong answers that come from
 * typical mistakes are computed too, so that each can be told by its name.
 */
package particles.teaching.exercises;
