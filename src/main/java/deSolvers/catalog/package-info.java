/**
 * The list of all solvers by name: for scenes, command lines, tables and tests.
 *
 * <h2>Adding a solver</h2>
 * <ol>
 * <li>{@code gradle newSolver -Pclass=HeunSolver} writes a class that compiles, in the style of the slides; on
 *     {@link deSolvers.FixedStepSolver}, the base class of the built-in solvers, only the formula is left to write.
 *     {@code gradle checkSolver -Psolver=exercises.HeunSolver} identifies its method and names mistakes.</li>
 * <li>Move the class into the package of its family, such as {@code deSolvers.rungeKutta}.</li>
 * <li>Give it an entry in {@link deSolvers.catalog.SolverCatalog} and a row in the solver table of {@code
 *     README.md}.</li>
 * <li>Write a test class that extends {@code DESolverContract}, which every solver passes.</li>
 * </ol>
 */
package deSolvers.catalog;
