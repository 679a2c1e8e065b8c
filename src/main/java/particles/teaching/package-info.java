/**
 * The base of all checks of students' work: {@link particles.teaching.Finding} is one mistake or note, {@link
 * particles.teaching.GuardedRun} runs a student's class with a limit on its CPU time, and {@link
 * particles.teaching.StudentFailure} names the line of it that failed.
 *
 * <p>Solvers are checked in {@code solvers}, on the test problems of {@code sources}, and measured in {@code figures};
 * force laws are checked in {@code effects}. The exercises are in {@code exercises}, and their marking in {@code
 * marking}.
 */
package particles.teaching;
