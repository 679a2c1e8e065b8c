package particles.rules;

import particles.ParticleSystem;

/** Removes particles whose lifetime is over, at the end of a step. Only emitted particles have a lifetime. */
public final class Lifetimes extends Deaths {
    @Override
    public String getName() {
        return "age";
    }

    @Override
    boolean goes(ParticleSystem system, int i) {
        return system.getParticles().deathTime(i) <= system.getTime();
    }
}
