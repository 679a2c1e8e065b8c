package particles.experiments.energy;

import particles.Motion;
import particles.Observer;
import particles.ParticleSystem;
import particles.Rule;

/**
 * Records a run's numerical energy error, and the energy that its forces and rules exchanged with the outside. It ends
 * a run that blows up when {@code gradle run} does.
 */
final class DriftRecorder implements Observer {
    private final EnergyHistory energy = new EnergyHistory();
    private final EnergyLedgerRecorder ledger = new EnergyLedgerRecorder(1);
    private final NumericalErrorLimit limit;
    private final ErrorCurve curve = new ErrorCurve();
    private double exchanged;

    /** @param energyEstimate the scene's estimated energy (J) */
    DriftRecorder(double energyEstimate) {
        limit = new NumericalErrorLimit(energy, ledger, energyEstimate);
    }

    @Override
    public void started(ParticleSystem system) {
        energy.started(system);
        ledger.started(system);
        curve.add(system.getTime(), ledger.getNumericalError());
    }

    @Override
    public void moved(Motion motion) {
        energy.moved(motion);
        ledger.moved(motion);
        curve.add(motion.getEndTime(), ledger.getNumericalError());
        for (double joules : ledger.getWork().values()) {
            if (Math.abs(joules) > exchanged) {
                exchanged = Math.abs(joules);
            }
        }
        limit.moved(motion);
    }

    @Override
    public void changed(ParticleSystem system, Rule rule) {
        energy.changed(system, rule);
        ledger.changed(system, rule);
    }

    ErrorCurve curve() {
        return curve;
    }

    /** @return the largest work of one kind, by damping, driving, bounces and so on (J); 0 where there is none */
    double exchanged() {
        return exchanged;
    }
}
