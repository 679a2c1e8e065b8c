/** The problems of the work-precision diagrams, with their references and budgets. */
package particles.experiments.problems;
