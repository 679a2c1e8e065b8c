package particles.lab;

import java.util.ArrayList;
import java.util.List;
import particles.ParticleSystem;
import particles.experiments.energy.EnergyLedgerRecorder;
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
    List<String> names() {
        return names;
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
