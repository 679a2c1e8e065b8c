package particles.rules;

import particles.ParticleSystem;
import particles.Rule;

/**
 * Particles die of age: those whose time has come are gone at the end of a step. Only emitted ones have such a time.
 */
public final class Lifetimes implements Rule {
    @Override
    public String getName() {
        return "age";
    }

    @Override
    public boolean afterStep(ParticleSystem system, double deltaT) {
        return Deaths.remove(system, (s, i) -> s.getParticles().deathTime(i) <= s.getTime());
    }
}
