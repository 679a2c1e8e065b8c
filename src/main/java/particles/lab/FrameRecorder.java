package particles.lab;

import particles.Motion;
import particles.Observer;
import particles.ParticleSystem;
import particles.Rule;
import particles.energy.EnergyLedgerRecorder;
import particles.scene.Scene;

/** Observer that records the frames of a run after its steps, in a limited amount of memory. */
final class FrameRecorder implements Observer {
    private final Scene scene;
    private final EnergyLedgerRecorder ledger;
    private final EnergyParts energies;
    private final History history;
    private Structure structure;

    /**
     * @param scene     a scene that is about to run
     * @param ledger    the energy ledger of its run
     * @param mostBytes the memory that the frames may take
     */
    FrameRecorder(Scene scene, EnergyLedgerRecorder ledger, long mostBytes) {
        this.scene = scene;
        this.ledger = ledger;
        energies = new EnergyParts(scene.system(), ledger);
        history = new History(mostBytes);
    }

    @Override
    public void started(ParticleSystem system) {
        structure = Structure.of(system);
        history.add(frame(system.getOwnState(), system.getTime(), structure));
    }

    @Override
    public void moved(Motion motion) {
        if (history.wants(motion.getEndTime())) {
            history.add(frame(motion.getEndState(), motion.getEndTime(), structure));
        }
    }

    @Override
    public void finished(ParticleSystem system) {
        if (history.last().time() < system.getTime()) {
            history.add(frame(system.getOwnState(), system.getTime(), structure));
        }
    }

    @Override
    public void changed(ParticleSystem system, Rule rule) {
        if (!structure.isOf(system)) {
            structure = Structure.of(system);
            if (history.last().time() == system.getTime()) {
                history.add(frame(system.getOwnState(), system.getTime(), structure));
            }
        }
    }

    /** The frame of a state of these particles. */
    Frame frame(double[] state, double time, Structure structure) {
        float[] copy = new float[6 * structure.ids().length];
        for (int i = 0; i < copy.length; i++) {
            copy[i] = (float) state[i];
        }
        Frame.Account account = new Frame.Account(scene.simulation().getSteps(), scene.system().getEvaluations(),
                ledger.getWork());
        return new Frame(time, copy, energies.of(state, time), structure, account);
    }

    /** The particles and springs at present. */
    Structure getStructure() {
        return structure;
    }

    History getHistory() {
        return history;
    }

    EnergyParts getEnergies() {
        return energies;
    }
}
