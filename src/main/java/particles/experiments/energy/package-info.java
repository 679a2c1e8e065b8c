/**
 * Energy experiments: energies over time, the ledger's numerical error, and the energy drift of solvers.
 */
package particles.experiments.energy;
