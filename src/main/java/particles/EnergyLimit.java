package particles;

import deSolvers.text.Digits;
import particles.law.Particles;

/**
 * Detects a blow-up: the kinetic energy above which a run is ended.
 *
 * @param joules positive; may be infinite
 */
record EnergyLimit(double joules) {
    EnergyLimit {
        if (!(joules > 0)) {
            throw new IllegalArgumentException("the energy limit has to be positive, not " + joules);
        }
    }

    /** @throws BlowUpException if the kinetic energy is above the limit; names the fastest particle */
    void check(ParticleSystem system) {
        double[] state = system.getOwnState();
        double energy = system.getKineticEnergy(state);
        if (energy <= joules) {
            return;
        }
        int fastest = fastest(system.getParticles(), state);
        throw new BlowUpException(system.getTime(), fastest, "the kinetic energy is " + Digits.few(energy)
                + " J, above the limit of " + Digits.few(joules) + " J; the fastest particle is '"
                + system.getParticles().id(fastest) + "'");
    }

    private static int fastest(Particles particles, double[] state) {
        int fastest = 0;
        double most = -1;
        for (int i = 0, v = 3; i < particles.count(); i++, v += Particles.STRIDE) {
            double square = state[v] * state[v] + state[v + 1] * state[v + 1] + state[v + 2] * state[v + 2];
            if (!particles.isFixed(i) && !(square <= most)) {
                most = square;
                fastest = i;
            }
        }
        return fastest;
    }
}
