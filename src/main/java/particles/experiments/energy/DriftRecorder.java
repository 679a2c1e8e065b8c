package particles.experiments.energy;

import particles.EnergyLedger;
import particles.Motion;
import particles.Observer;
import particles.ParticleSystem;
import particles.Rule;

/** Records a run's numerical energy error, and the energy that its forces and rules exchanged with the outside. */
final class DriftRecorder implements Observer {
    private final EnergyLedger ledger = new EnergyLedger();
    private final ErrorCurve curve = new ErrorCurve();
    private double exchanged;

    @Override
    public void started(ParticleSystem system) {
        ledger.started(system);
        curve.add(system.getTime(), ledger.getNumericalError());
    }

    @Override
    public void moved(Motion motion) {
        ledger.moved(motion);
        curve.add(motion.getEndTime(), ledger.getNumericalError());
        for (double joules : ledger.getWork().values()) {
            if (Math.abs(joules) > exchanged) {
                exchanged = Math.abs(joules);
            }
        }
    }

    @Override
    public void changed(ParticleSystem system, Rule rule) {
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
