/** Problems with known solutions, to hold solvers against. Facts from mathematics only, never from a solver. */
package deSolvers.problems;
