package particles.lab;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import particles.ParticleSystem;
import particles.energy.EnergyLedgerRecorder;
import particles.law.Effect;

/**
 * The energy of a run and its parts: total energy, kinetic energy, the potential energy of each effect, and the
 * numerical error.
 */
final class EnergyParts {
    private final ParticleSystem system;
    private final EnergyLedgerRecorder ledger;
    private final List<Effect> effects = new ArrayList<>();
    private final List<String> names = new ArrayList<>(List.of("total", "kinetic"));

    /**
     * @param system the system at its start
     * @param ledger the energy ledger of its run
     */
    EnergyParts(ParticleSystem system, EnergyLedgerRecorder ledger) {
        this.system = system;
        this.ledger = ledger;
        for (Effect effect : system.getEffects()) {
            effects.add(effect);
            names.add(effect.getName());
        }
        names.add("numerical error");
    }

    /** The names of the numbers. */
    List<String> getNames() {
        return names;
    }

    /**
     * The numbers of the uniform fields, such as gravity: a chart has their zero at their lowest value in the run, so
     * that the choice of the origin does not matter.
     */
    List<Integer> uniform() {
        return IntStream.range(0, effects.size()).filter(e -> Effect.Trait.isUniform(effects.get(e)))
                .mapToObj(e -> e + 2).toList();
    }

    /** The energies of a state (J); the numerical error is that of the ledger so far. */
    float[] of(double[] state, double time) {
        float[] energies = new float[names.size()];
        double kinetic = system.getKineticEnergy(state);
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
}
