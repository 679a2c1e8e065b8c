package particles.output;

import java.util.function.Predicate;
import particles.ParticleSystem;
import particles.Rule;
import particles.law.Effect;

/** Small forces for tests of observers. */
public final class TestEffects {
    private TestEffects() {
    }

    private abstract static class Base implements Effect {
        private final String name;

        Base(String name) {
            this.name = name;
        }

        @Override
        public String getName() {
            return name;
        }

        @Override
        public boolean dependsOnVelocity() {
            return false;
        }
    }

    /** Weight m g downwards for every particle of the system. */
    public static Effect gravity(ParticleSystem system, double g) {
        return new Base("gravity") {
            @Override
            public void addForces(double[] state, double time, double[] force) {
                for (int i = 0; i < system.getParticles().count(); i++) {
                    force[6 * i + 4] -= system.getParticles().mass(i) * g;
                }
            }

            @Override
            public double getPotentialEnergy(double[] state, double time) {
                double energy = 0;
                for (int i = 0; i < system.getParticles().count(); i++) {
                    energy += system.getParticles().mass(i) * g * state[6 * i + 1];
                }
                return energy;
            }
        };
    }

    /** No force until a time, then NaN. */
    public static Effect failingAt(double when) {
        return new Base("failing") {
            @Override
            public void addForces(double[] state, double time, double[] force) {
                if (time > when) {
                    force[3] = Double.NaN;
                }
            }
        };
    }

    /** @return a rule that acts after each step, and says whether it changed anything */
    public static Rule rule(Predicate<ParticleSystem> act) {
        return new Rule() {
            @Override
            public String getName() {
                return "test";
            }

            @Override
            public boolean afterStep(ParticleSystem system, double deltaT) {
                return act.test(system);
            }
        };
    }
}
