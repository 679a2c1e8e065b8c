package particles.output;

import particles.ParticleSystem;
import particles.effects.Gravity;
import particles.law.Effect;
import particles.law.Vector3;

/** Small forces for tests of observers. */
public final class TestEffects {
    private TestEffects() {
    }

    /** No force until a time, then NaN. */
    public static Effect failingAt(double when) {
        return new Effect() {
            @Override
            public String getName() {
                return "failing";
            }

            @Override
            public boolean dependsOnVelocity() {
                return false;
            }

            @Override
            public void addForces(double[] state, double time, double[] force) {
                if (time > when) {
                    force[3] = Double.NaN;
                }
            }
        };
    }

    /** @return weight, m g downwards, for every particle of the system */
    public static Effect gravity(ParticleSystem system, double g) {
        return new Gravity(system.getParticles(), new Vector3(0, -g, 0));
    }
}
