package particles.teaching.effects;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.function.Function;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import particles.law.Effect;
import particles.law.Particles;
import particles.spec.ClassNames;
import particles.teaching.Finding;

/** Every planted mistake of a force law is named; the laws of our own pass. */
class PlantedEffectsTest {

    /** A law on every particle, as students write it; subclasses go wrong. */
    private abstract static class PerParticle implements Effect {
        final Particles particles;
        private final Set<Trait> traits;

        PerParticle(Particles particles, Trait... traits) {
            this.particles = particles;
            this.traits = EnumSet.copyOf(List.of(traits));
        }

        @Override
        public String getName() {
            return "planted";
        }

        @Override
        public Set<Trait> getTraits() {
            return EnumSet.copyOf(traits);
        }

        @Override
        public boolean dependsOnVelocity() {
            return traits.contains(Trait.DISSIPATIVE);
        }
    }

    /** Gravity along -y with places to go wrong: factors of force and energy, and their powers of the mass. */
    private static Function<Particles, Effect> gravity(double force, int massPower, double energy, int offset,
            boolean add) {
        return p -> new PerParticle(p, Effect.Trait.CONSERVATIVE) {
            @Override
            public void addForces(double[] state, double time, double[] f) {
                for (int i = 0; i < particles.count(); i++) {
                    double value = -force * 9.81 * (massPower == 1 ? particles.mass(i) : 1);
                    f[6 * i + offset] = (add ? f[6 * i + offset] : 0) + value;
                }
            }

            @Override
            public double getPotentialEnergy(double[] state, double time) {
                double sum = 0;
                for (int i = 0; i < particles.count(); i++) {
                    sum += energy * particles.mass(i) * 9.81 * state[6 * i + 1];
                }
                return sum;
            }
        };
    }

    /** A chain of springs of stiffness 10 and rest length 0: F = k r, V = k r^2 / 2. */
    private static Function<Particles, Effect> chain(double own, double partner, double energy) {
        return p -> new PerParticle(p, Effect.Trait.INTERNAL, Effect.Trait.CONSERVATIVE) {
            @Override
            public void addForces(double[] state, double time, double[] f) {
                for (int s = 0; s < particles.count() - 1; s++) {
                    for (int c = 0; c < 3; c++) {
                        double force = 10 * (state[6 * s + 6 + c] - state[6 * s + c]);
                        f[6 * s + 3 + c] += own * force;
                        f[6 * s + 9 + c] += partner * force;
                    }
                }
            }

            @Override
            public double getPotentialEnergy(double[] state, double time) {
                double sum = 0;
                for (int k = 0; k + 6 < state.length; k += k % 6 == 2 ? 4 : 1) {
                    sum += energy * 10 * (state[k + 6] - state[k]) * (state[k + 6] - state[k]);
                }
                return sum;
            }
        };
    }

    private static Function<Particles, Effect> drag(double factor) {
        return p -> new PerParticle(p, Effect.Trait.DISSIPATIVE) {
            @Override
            public void addForces(double[] state, double time, double[] f) {
                for (int k = 3; k < f.length; k += k % 6 == 5 ? 4 : 1) {
                    f[k] -= factor * 0.4 * state[k];
                }
            }

            @Override
            public double getDissipatedPower(double[] state, double time) {
                double sum = 0;
                for (int k = 3; k < state.length; k += k % 6 == 5 ? 4 : 1) {
                    sum += 0.4 * state[k] * state[k];
                }
                return sum;
            }
        };
    }

    private static void assertFound(Function<Particles, Effect> maker, String... expected) {
        List<Finding> found = EffectCheck.check(maker);
        assertEquals(expected.length == 0 ? 0 : 1, found.size(), found.toString());
        for (String part : expected) {
            assertTrue(found.get(0).toString().contains(part), found.get(0) + " does not say: " + part);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"gravity", "springs", "damped-springs", "drag", "quadraticDrag", "attraction",
            "cohesion", "repulsion", "penaltyPlane"})
    void ourOwnEffectsPass(String name) {
        assertFound(p -> EffectSample.create(name, p, ClassNames.none()));
    }

    @Test
    void withoutAMistakeNothingIsFound() {
        assertFound(gravity(1, 1, 1, 4, true));
        assertFound(chain(1, -1, 0.5));
        assertFound(drag(1));
    }

    @Test
    void signOfGravity() {
        assertFound(gravity(-1, 1, 1, 4, true), "method: component y of the force on particle 'p0'",
                "the sign is wrong");
    }

    @Test
    void massMissingInTheForce() {
        assertFound(gravity(1, 0, 1, 4, true), "component y of the force on particle 'p0'",
                "the mass is missing in the force");
    }

    @Test
    void forceInThePositionsPlace() {
        assertFound(gravity(1, 1, 1, 1, true), "state: component y of the force on particle 'p0' is written to entry "
                + "1, where the position stands");
    }

    @Test
    void forceAlongAnotherAxis() {
        assertFound(gravity(1, 1, 1, 3, true), "component x of the force on particle 'p0'", "only x and y are wrong");
    }

    @Test
    void forceSetInsteadOfAdded() {
        assertFound(gravity(1, 1, 1, 4, false), "state: component y of the force on particle 'p0' is set and not added "
                + "(= instead of +=)");
    }

    @Test
    void partnerForgotten() {
        assertFound(chain(1, 0, 0.5), "method: particle 'p1' pushes 'p0', and is not pushed itself: the partner's"
                + " force F_ji = -F_ij is missing");
    }

    @Test
    void partnerPushedTheSameWay() {
        assertFound(chain(1, 1, 0.5), "particle 'p1' pushes 'p0', and gets the same force itself");
    }

    @Test
    void springThatPushesWhenStretched() {
        assertFound(chain(-1, 1, 0.5), "component x of the force on particle 'p0'", "the sign is wrong");
    }

    @Test
    void halfMissingInTheEnergy() {
        assertFound(chain(1, -1, 1), "the half is missing in the potential energy");
    }

    @Test
    void dragThatDrives() {
        assertFound(drag(-1), "the sign is wrong; damping has to push against the velocity");
    }

    @Test
    void dragOfTwiceTheSize() {
        assertFound(drag(2), "twice as much; a half stands in the dissipated power");
    }

    /** Force and energy agree, and both may be upside down: the measured direction is told, and the reader knows. */
    @Test
    void whereItPointsIsMeasured() {
        assertEquals(" Measured: it points along -y.", ForceDirection.of(gravity(1, 1, 1, 4, true)));
        assertEquals(" Measured: it points along +y.", ForceDirection.of(gravity(-1, 1, -1, 4, true)));
        assertEquals(" Measured: it pulls particles together.", ForceDirection.of(chain(1, -1, 0.5)));
        assertEquals(" Measured: it pushes particles apart.", ForceDirection.of(chain(-1, 1, -0.5)));
        assertEquals(" Measured: it brakes what moves.", ForceDirection.of(drag(1)));
        assertEquals(" Measured: it pushes along the velocity.", ForceDirection.of(drag(-1)));
    }

    @Test
    void aNumberOfParticlesThatIsWrittenDown() {
        assertFound(p -> new PerParticle(p, Effect.Trait.CONSERVATIVE) {
            @Override
            public void addForces(double[] state, double time, double[] f) {
                for (int i = 0; i < 6; i++) {
                    f[6 * i + 4] -= 9.81 * particles.mass(i);
                }
            }

            @Override
            public double getPotentialEnergy(double[] state, double time) {
                double sum = 0;
                for (int i = 0; i < particles.count(); i++) {
                    sum += particles.mass(i) * 9.81 * state[6 * i + 1];
                }
                return sum;
            }
        }, "there is no force on particle 'p6', 'p7', 'p8', and the right one on all others; the loop has to");
    }
}
