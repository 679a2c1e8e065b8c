/**
 * Energy over time, the ledger's numerical error, and how solvers drift.
 */
package particles.experiments.energy;
