package particles.rules;

import particles.ParticleSystem;
import particles.Rule;

/** A rule that removes particles at the end of a step. */
abstract class Deaths implements Rule {
    /** Whether a particle is to be removed. */
    abstract boolean goes(ParticleSystem system, int i);

    @Override
    public final boolean afterStep(ParticleSystem system, double deltaT) {
        boolean[] gone = new boolean[system.getParticles().count()];
        boolean any = false;
        for (int i = 0; i < gone.length; i++) {
            gone[i] = goes(system, i);
            any |= gone[i];
        }
        if (any) {
            system.removeParticles(gone);
        }
        return any;
    }
}
