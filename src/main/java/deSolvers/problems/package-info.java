/**
 * Reference problems: small differential equations to try a solver on, most of them with a known solution.
 *
 * <p>A problem class has only its equation and, where a formula is known, {@link
 * deSolvers.problems.ReferenceProblem#exactState}. State, clock and the count of evaluations are in {@link
 * deSolvers.problems.ReferenceProblem}, the layout of positions and velocities in {@link
 * deSolvers.problems.SecondOrderProblem}. To try a solver of your own:
 * <pre>
 * Oscillator oscillator = new Oscillator();
 * for (int i = 0; i &lt; 100; i++) {
 *     solver.stepState(oscillator, 0.1);
 * }
 * oscillator.error();            // the distance from the exact solution at t = 10
 * oscillator.getEvaluations();   // what it cost
 * </pre>
 *
 * <p>{@link deSolvers.problems.StepMatrix} measures the matrix by which a step multiplies the state of a linear
 * problem.
 */
package deSolvers.problems;
