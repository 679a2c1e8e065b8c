/**
 * Hard cases for the solvers alone: each class says why its case is hard and what every solver has to do with it -
 * follow it, stay bounded, grow as documented, or fail loudly with everything put back. Run by
 * {@code gradle hardTests}.
 */
package deSolvers.hard;
