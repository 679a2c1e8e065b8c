/** The one list of all solvers, by name: for scenes, command lines, tables and tests. */
package deSolvers.catalog;
