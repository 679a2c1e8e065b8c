package particles;

import deSolvers.text.Digits;
import particles.SimulationException.End;
import particles.law.Particles;
import particles.law.Vector3;

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
        int fastest = fastest(system.getParticles(), state);
        throw new SimulationException(End.ENERGY_LIMIT, system.getTime(), fastest, "the kinetic energy is "
                + Digits.few(energy) + " J, above the limit of " + Digits.few(joules)
                + " J; the fastest particle is '" + system.getParticles().id(fastest) + "'");
    }

    private static int fastest(Particles particles, double[] state) {
        int fastest = 0;
        double most = -1;
        for (int i = 0; i < particles.count(); i++) {
            Vector3 v = Vector3.at(state, Particles.STRIDE * i + 3);
            double square = v.dot(v);
            if (!particles.isFixed(i) && !(square <= most)) {
                most = square;
                fastest = i;
            }
        }
        return fastest;
    }
}
