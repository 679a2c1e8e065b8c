/**
 * Programs that look for mistakes in DESolver itself. What they find becomes a test.
 *
 * <ul>
 * <li>{@code gradle fuzz} reads valid scenes with random changes. One execution in 30 is a whole scene, drawn at
 *     random with one of all solvers: rods keep their lengths, contacts their depth, free systems their momentum, the
 *     ledger closes, finer steps are nearer to the exact motion. {@code -Pexecutions=40000 -Pseed=1} takes one or
 *     two minutes; without a seed the scenes differ each time, and without a number of executions it runs for twenty
 *     minutes ({@code -Pseconds} sets another time).</li>
 * <li>{@code gradle mutationTests -Ppackage=deSolvers.symplectic} changes the classes of a package, one instruction
 *     at a time, and counts the changes that a test notices: at least 85 % must be noticed. On two cores this takes
 *     one to ten minutes, and about twenty for {@code deSolvers.implicit}. Without a package it tests all of
 *     them.</li>
 * </ul>
 */
package hunts;
