/**
 * Problems with known solutions that only tests use, sources that watch a solver, and curves of its work. Facts from
 * mathematics only, never from a solver.
 */
package deSolvers.problems;
