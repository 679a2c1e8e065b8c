package particles.lab;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import particles.Motion;
import particles.Observer;
import particles.ParticleSystem;
import particles.Rule;
import particles.energy.EnergyLedgerRecorder;
import particles.lab.Frame.Structure;
import particles.law.Effect;
import particles.scene.Scene;

/** Observer that records the frames of a run after its steps, in a limited amount of memory. */
final class FrameRecorder implements Observer {
    private final Scene scene;
    private final EnergyLedgerRecorder ledger;
    private final List<Effect> effects;                 // of the scene, without the pointer's
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
        effects = List.copyOf(scene.system().getEffects());
        history = new History(mostBytes);
    }

    @Override
    public void started(ParticleSystem system) {
        structure = Structure.of(system);
        addPresent(system);
    }

    private void addPresent(ParticleSystem system) {
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
            addPresent(system);
        }
    }

    @Override
    public void changed(ParticleSystem system, Rule rule) {
        if (!structure.isOf(system)) {
            structure = Structure.of(system);
            if (history.last().time() == system.getTime()) {
                addPresent(system);
            }
        }
    }

    /** The frame of a state of these particles. */
    Frame frame(double[] state, double time, Structure structure) {
        float[] copy = new float[6 * structure.ids().length];
        for (int i = 0; i < copy.length; i++) {
            copy[i] = (float) state[i];
        }
        return new Frame(time, copy, energies(state, time), structure, new Frame.Account(
                scene.simulation().getSteps(), scene.system().getEvaluations(), ledger.getWork()));
    }

    /** The particles and springs at present. */
    Structure getStructure() {
        return structure;
    }

    History getHistory() {
        return history;
    }

    /** The energies of a state (J); the numerical error is that of the ledger so far. */
    private float[] energies(double[] state, double time) {
        float[] energies = new float[effects.size() + 3];
        double kinetic = scene.system().getKineticEnergy(state);
        double total = kinetic;
        for (int e = 0; e < effects.size(); e++) {
            double stored = effects.get(e).getPotentialEnergy(state, time);
            energies[e + 2] = (float) stored;
            total += stored;
        }
        energies[0] = (float) total;
        energies[1] = (float) kinetic;
        energies[energies.length - 1] = (float) ledger.getNumericalError();
        return energies;
    }

    /** The names of a frame's energies: the total, the kinetic energy, each effect's and the numerical error. */
    List<String> getEnergyNames() {
        List<String> names = new ArrayList<>(List.of("total", "kinetic"));
        effects.forEach(effect -> names.add(effect.getName()));
        names.add("numerical error");
        return names;
    }

    /**
     * The places of uniform fields, such as gravity, in a frame's energies: a chart has their zero at their lowest
     * value in the run, so that the choice of the origin does not matter.
     */
    List<Integer> getUniform() {
        return IntStream.range(0, effects.size()).filter(e -> Effect.Trait.isUniform(effects.get(e)))
                .mapToObj(e -> e + 2).toList();
    }
}
