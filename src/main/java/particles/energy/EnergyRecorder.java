package particles.energy;

import java.util.List;
import java.util.Optional;
import particles.Observer;
import particles.Simulation;

/** Records all that a run's energy says: its history, its ledger, and whether the steps resolve what vibrates. */
public final class EnergyRecorder {
    private final EnergyHistory history;
    private final EnergyLedgerRecorder ledger;
    private final Resolution resolution;
    private final NumericalErrorLimit limit;

    /**
     * @param simulation     the run
     * @param energyEstimate the scene's estimated energy (J)
     * @param stride         the number of steps from one record to the next, 1 or more
     */
    public EnergyRecorder(Simulation simulation, double energyEstimate, long stride) {
        history = new EnergyHistory(stride);
        ledger = new EnergyLedgerRecorder(stride);
        resolution = new Resolution(simulation.getDeltaT(), simulation.getDuration());
        limit = new NumericalErrorLimit(history, ledger, energyEstimate);
    }

    /**
     * Observes a run, and ends it when its motion is mostly numerical error.
     *
     * @param simulation the run
     * @param others     observers that see each step after it was recorded, also the one that ends the run
     */
    public void attachTo(Simulation simulation, Iterable<? extends Observer> others) {
        List.of(history, ledger, resolution).forEach(simulation::addObserver);
        others.forEach(simulation::addObserver);
        simulation.addObserver(limit);
    }

    /** @return the energies over time, and the energy scale */
    public EnergyHistory getHistory() {
        return history;
    }

    /** @return the work of each kind, and the numerical error */
    public EnergyLedgerRecorder getLedger() {
        return ledger;
    }

    /** @return the energy scale: the largest kinetic plus stored energy that is no numerical error (J) */
    public double getScale() {
        return limit.getScale();
    }

    /** @return whether a visible vibration has fewer than {@value Resolution#STEPS} steps per period */
    public boolean isTooCoarse() {
        return resolution.isTooCoarse(getScale());
    }

    /** @return what may come and go in less time than four steps take, if anything may */
    public Optional<Resolution.Brief> getBrief() {
        return resolution.getBrief();
    }
}
