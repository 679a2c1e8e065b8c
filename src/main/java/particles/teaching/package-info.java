/**
 * Shared by all checks of students' work: {@link particles.teaching.Finding} is one mistake or note,
 * {@link particles.teaching.GuardedRun} runs a student's class with a limit to its computing time, and
 * {@link particles.teaching.StudentFailure} names the line of it that failed.
 *
 * <p>Solvers are checked in {@code solvers}, on the test problems of {@code sources}, and measured in {@code figures};
 * force
 * laws are checked in {@code effects}. The tasks are in {@code exercises}, and how an answer is marked in {@code
 * marking}.
 */
package particles.teaching;
