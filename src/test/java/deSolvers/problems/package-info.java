/**
 * Test problems with known solutions, sources that observe a solver, and work-precision curves. Reference values come
 * from mathematics, never from a solver.
 */
package deSolvers.problems;
