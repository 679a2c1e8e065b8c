package particles.rules;

import particles.ParticleSystem;
import particles.Rule;

/** Removes particles whose lifetime is over, at the end of a step. Only emitted particles have a lifetime. */
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
