package particles;

import deSolvers.text.Digits;
import particles.SimulationException.End;

/**
 * Ends a run that has blown up: the last of its rules, which changes nothing. The observer {@code NumericalErrorLimit}
 * ends most blow-ups of a scene earlier, by their numerical error; this one needs no ledger.
 *
 * @param joules the kinetic energy above which a run has blown up (J), positive; may be infinite
 */
public record EnergyLimit(double joules) implements Rule {
    /** @throws IllegalArgumentException if the limit is not positive */
    public EnergyLimit {
        if (!(joules > 0)) {
            throw new IllegalArgumentException("the energy limit has to be positive, not " + joules);
        }
    }

    @Override
    public String getName() {
        return "energy limit";
    }

    /** @throws SimulationException if the kinetic energy is above the limit; names the fastest particle */
    @Override
    public boolean afterStep(ParticleSystem system, double deltaT) {
        double[] state = system.getOwnState();
        double energy = system.getKineticEnergy(state);
        if (energy <= joules) {
            return false;
        }
        throw new SimulationException(End.ENERGY_LIMIT, system.getTime(), system.getParticles().fastest(state),
                Digits.format("the kinetic energy is %s J, above the limit of %s J", Digits.few(energy),
                Digits.few(joules)));
    }
}
