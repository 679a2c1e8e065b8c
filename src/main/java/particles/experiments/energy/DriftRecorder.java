package particles.experiments.energy;

import particles.Motion;
import particles.Observer;
import particles.ParticleSystem;
import particles.energy.EnergyRecorder;
import particles.scene.Scene;

/**
 * Records a run's numerical energy error, and the energy that its forces and rules exchanged with the outside. It ends
 * a run that blows up when {@code gradle run} does.
 */
final class DriftRecorder implements Observer {
    private final EnergyRecorder energy;
    private final ErrorCurve curve = new ErrorCurve();
    private double exchanged;

    /** @param scene the scene that is about to run */
    DriftRecorder(Scene scene) {
        energy = new EnergyRecorder(scene.simulation(), scene.energyEstimate(), 1);
        energy.observers().forEach(scene.simulation()::addObserver);
    }

    @Override
    public void started(ParticleSystem system) {
        curve.add(system.getTime(), energy.getLedger().getNumericalError());
    }

    @Override
    public void moved(Motion motion) {
        curve.add(motion.getEndTime(), energy.getLedger().getNumericalError());
        for (double joules : energy.getLedger().getWork().values()) {
            exchanged = Math.max(exchanged, Math.abs(joules));
        }
        energy.getLimit().moved(motion);
    }

    ErrorCurve getCurve() {
        return curve;
    }

    /** @return the largest work of one kind, by damping, driving, bounces and so on (J); 0 where there is none */
    double getExchanged() {
        return exchanged;
    }
}
