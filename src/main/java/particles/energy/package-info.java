/**
 * The energy of a run: its history, its ledger, its one scale, the end of a run whose energy is numerical error, and
 * whether the steps resolve what vibrates. {@link particles.energy.EnergyRecorder} keeps all of it.
 */
package particles.energy;
