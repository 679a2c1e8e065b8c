package particles.teaching.collection;

import static particles.teaching.collection.EffectSpecimen.wrong;
import static particles.teaching.collection.Law.each;
import static particles.teaching.collection.Law.law;
import static particles.teaching.collection.Law.own;
import static particles.teaching.collection.Law.pairEnergy;
import static particles.teaching.collection.Law.pairs;
import static particles.teaching.collection.Law.push;
import static particles.teaching.collection.Law.square;
import static particles.teaching.collection.Law.sum;

import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.stream.Stream;
import particles.law.Effect.Trait;
import particles.law.ParticleForce;
import particles.law.Particles;
import particles.law.PerParticleEffect;
import particles.law.Vector3;

/** Wrong force laws in the styles that students write, each with one mistake. */
final class WrongEffects {
    private static final double G = 9.81;

    private WrongEffects() {
    }

    static List<EffectSpecimen> all() {
        return Stream.of(signs(), energies(), claims(), indices(), pairsOfParticles()).flatMap(List::stream).toList();
    }

    static Law gravity(Particles p, double force, double energy) {
        return law("Gravity", Trait.CONSERVATIVE).force(each(p, (s, f, x, m) -> f[x + 4] -= force * m * G))
                .energy(sum(p, (s, x, m) -> energy * m * G * s[x + 1]));
    }

    static Law drag(Particles p, double force, double heat, Trait... traits) {
        return law("Drag", traits).moving().force(each(p, (s, f, x, m) -> push(f, x, -0.4 * force, s, x + 3)))
                .heat(sum(p, (s, x, m) -> 0.4 * heat * square(s, x + 3)));
    }

    static Law tether(Particles p, double force, double energy, Trait... traits) {
        return law("Tether", traits).force(each(p, (s, f, x, m) -> push(f, x, -4 * force, s, x)))
                .energy(sum(p, (s, x, m) -> 2 * energy * square(s, x)));
    }

    private static List<EffectSpecimen> signs() {
        return List.of(
                wrong("Gravity.", "force upwards",
                        "^method: component y of the force on particle 'p0' is 11.68 N .* -11.68 N;.* is -1 times that",
                        p -> gravity(p, -1, 1)),
                wrong("Gravity.", "energy falls with height", "is -1 times that", p -> gravity(p, 1, -1)),
                wrong("Drag.", "pushes along",
                        "is -1 times that",
                        p -> drag(p, -1, 1, Trait.DISSIPATIVE)),
                wrong("Drag.", "heat negative", "heat is never negative",
                        p -> drag(p, 1, -1, Trait.DISSIPATIVE)),
                wrong("Drag.", "pushes along and cools", "heat is never negative", p -> drag(p, -1, -1,
                        Trait.DISSIPATIVE)),
                wrong("Drag with the square of the speed", "v * v has no sign", "at -1 m/s; .*is -1 times that",
                        p -> law("QuadraticDrag", Trait.DISSIPATIVE).moving().force(each(p, (s, f, x, m) -> {
                            for (int k = x + 3; k < x + 6; k++) {
                                f[k] -= 0.2 * s[k] * s[k];
                            }
                        })).heat(sum(p, (s, x, m) -> 0.2 * (Math.abs(s[x + 3] * s[x + 3] * s[x + 3])
                                + Math.abs(s[x + 4] * s[x + 4] * s[x + 4])
                                + Math.abs(s[x + 5] * s[x + 5] * s[x + 5]))))));
    }

    private static List<EffectSpecimen> energies() {
        return List.of(
                wrong("Gravity.", "no mass in the force",
                        "'p0' is -9.810 N.*ask for -11.68 N; wrong are y on",
                        p -> gravity(p, 1, 1).force(each(p, (s, f, x, m) -> f[x + 4] -= G))),
                wrong("Gravity.", "no mass in the energy", "wrong are y on 'p0'",
                        p -> gravity(p, 1, 1).energy(sum(p, (s, x, m) -> G * s[x + 1]))),
                wrong("Gravity.", "no energy", "on every particle: one of them is missing", p -> gravity(p, 1, 0)),
                wrong("Gravity.", "energy goes with x",
                        "wrong are x, y on 'p0', 'p1', 'p2', 'p3', 'p5'", p -> gravity(p, 1, 1).energy(sum(p, (s, x, m)
                        -> m * G * s[x]))),
                wrong("A spring to the origin.", "no half in the energy",
                        "is 1/2 times that", p -> tether(p, 1, 2, Trait.CONSERVATIVE)),
                wrong("A spring to the origin.", "1/2 of whole numbers", "1/2 is 0", p -> tether(p, 1, 1,
                        Trait.CONSERVATIVE).energy(sum(p, (s, x, m) -> 1 / 2 * 4 * square(s, x)))),
                wrong("Drag.", "a half in the heat",
                        "is 2 times that",
                        p -> drag(p, 1, 0.5, Trait.DISSIPATIVE)),
                wrong("Drag.", "no heat", "on every particle: one of them is missing",
                        p -> drag(p, 1, 0, Trait.DISSIPATIVE)),
                wrong("Chain of springs", "rest length left out of the energy",
                        "wrong are x, y, z on .*state: .0, 1, 2, 6, 7, 8.",
                        p -> law("Chain", Trait.CONSERVATIVE)
                        .force((s, t, f) -> RightEffects.chain(p, s, f, 20, 0.8, 0, false))
                        .energy((s, t) -> RightEffects.chainEnergy(p, s, 20, 0, false))),
                wrong("Sun", "r^2 and not r^3 below the vector",
                        "wrong are x, y, z on", p -> law("Sun", Trait.CONSERVATIVE)
                        .force(each(p, (s, f, x, m) -> push(f, x, -m / square(s, x), s, x)))
                        .energy(sum(p, (s, x, m) -> -m / Math.sqrt(square(s, x))))),
                wrong("Damped springs", "the dampers' heat left out", "getDissipatedPower", p -> law("Damped",
                        Trait.DISSIPATIVE).moving()
                        .force((s, t, f) -> RightEffects.chain(p, s, f, 20, 0.8, 0.5, false))
                        .energy((s, t) -> RightEffects.chainEnergy(p, s, 20, 0.8, false))),
                wrong("Damped springs", "the springs' energy left out", "getPotentialEnergy", p -> law("Damped",
                        Trait.DISSIPATIVE).moving()
                        .force((s, t, f) -> RightEffects.chain(p, s, f, 20, 0.8, 0.5, false))
                        .heat((s, t) -> RightEffects.chainHeat(p, s, 0.5))),
                wrong("A spring to the origin.", "energy 5/2 times as large", "is 2/5 times that",
                        p -> tether(p, 1, 2.5, Trait.CONSERVATIVE)),
                wrong("Drag.", "twice the heat, and claims to drive",
                        "is 1/2 times that", p -> drag(p, 1, 2, Trait.DISSIPATIVE, Trait.DRIVING)),
                wrong("Shaker", "no driven power", "getDrivenPower", p -> law("Shaker", Trait.DRIVING)
                        .force(each(p, (s, f, x, m) -> f[x + 3] += 0.7))));
    }

    private static List<EffectSpecimen> claims() {
        return List.of(
                wrong("Gravity.", "claims INTERNAL", "claims INTERNAL", p -> gravity(p, 1, 1)
                        .claiming(Trait.CONSERVATIVE, Trait.INTERNAL)),
                wrong("A spring to the origin.", "claims INTERNAL", "claims INTERNAL", p -> tether(p, 1, 1,
                        Trait.CONSERVATIVE, Trait.INTERNAL)),
                wrong("Drag.", "claims INTERNAL", "claims INTERNAL", p -> drag(p, 1, 1, Trait.DISSIPATIVE,
                        Trait.INTERNAL)),
                wrong("Gravity.", "claims no direction",
                        "claims ROTATION_INVARIANT, and with everything turned alike component", p -> gravity(p, 1, 1)
                        .claiming(Trait.CONSERVATIVE, Trait.ROTATION_INVARIANT)),
                wrong("A spring to the origin.", "claims no place", "claims TRANSLATION_INVARIANT, and with",
                        p -> tether(p, 1, 1, Trait.CONSERVATIVE, Trait.TRANSLATION_INVARIANT)),
                wrong("Drag.", "claims CONSERVATIVE", "on every particle: .*or a claim is wrong", p -> drag(p, 1, 0,
                        Trait.CONSERVATIVE)),
                wrong("Drag.", "claims to conserve and to dissipate", "contradict", p -> drag(p, 1, 1,
                        Trait.CONSERVATIVE, Trait.DISSIPATIVE)),
                wrong("Gravity.", "claims to conserve and to drive", "contradict", p -> gravity(p, 1, 1)
                        .claiming(Trait.CONSERVATIVE, Trait.DRIVING)),
                wrong("Gravity.", "claims DISSIPATIVE for what does not damp", "or a claim is wrong",
                        p -> gravity(p, 1, 0)
                        .claiming(Trait.DISSIPATIVE)),
                wrong("Drag.", "says that velocities do not count", "dependsOnVelocity", p -> drag(p, 1, 1,
                        Trait.DISSIPATIVE).still()),
                wrong("Drag.", "claims nothing", "claim DISSIPATIVE, or return 0", p -> drag(p, 1, 1)),
                wrong("Drag in wind", "the wind's work is not told", "DRIVING|getDrivenPower", p -> drag(p, 1, 1,
                        Trait.DISSIPATIVE).force(each(p, (s, f, x, m) -> {
                            push(f, x, -0.4, s, x + 3);
                            f[x + 3] += 0.8;
                        }))),
                wrong("Swirl around the y axis", "claims CONSERVATIVE with no energy", "or a claim is wrong",
                        p -> law("Swirl", Trait.CONSERVATIVE).force(each(p, (s, f, x, m) -> {
                            f[x + 3] += s[x + 2];
                            f[x + 5] -= s[x];
                        }))));
    }

    private static List<EffectSpecimen> indices() {
        Random random = new Random(9);
        double[] kept = new double[600];
        return List.of(
                wrong("Gravity.", "stride 3", "stride|6 i|position stands", p -> gravity(p, 1, 1).force((s, t, f) -> {
                    for (int i = 0; i < p.count(); i++) {
                        f[3 * i + 1] -= p.mass(i) * G;
                    }
                })),
                wrong("Gravity.", "written over the position", "^state: component y of the force on particle 'p0'"
                        + " is written to entry 1, where the position stands", p -> gravity(p, 1, 1).force(each(p,
                        (s, f, x, m) -> f[x + 1] -= m * G))),
                wrong("Gravity.", "written over a position later", "written to entry 0, where the position stands",
                        p -> law("Gravity").force((s, t, f) -> {
                            f[4] -= 1;
                            f[0] += t > 1 ? 1 : 0;
                        })),
                wrong("A spring to the origin.", "positions read with stride 3",
                        "on particle 'p1' .*these entries of the state: .3.",
                        p -> tether(p, 1, 1, Trait.CONSERVATIVE).force(each(p, (s, f, x, m)
                        -> push(f, x, -4, s, x / 2)))),
                wrong("A spring to the origin.", "velocity read for the position",
                        "'p0' .*these entries of the state: .3.",
                        p -> tether(p, 1, 1, Trait.CONSERVATIVE).force(each(p, (s, f, x, m)
                        -> push(f, x, -4, s, x + 3)))),
                wrong("A spring to the origin.", "force to another centre", "wrong are x on",
                        p -> tether(p, 1, 1, Trait.CONSERVATIVE).moving().force(each(p, (s, f, x, m) -> {
                            push(f, x, -4, s, x);
                            f[x + 3] += 4;
                        }))),
                wrong("Drag.", "position read for the velocity",
                        "'p0' .*these entries of the state: .0.", p -> drag(p, 1, 1, Trait.DISSIPATIVE)
                        .force(each(p, (s, f, x, m) -> push(f, x, -0.4, s, x)))),
                wrong("Gravity.", "begins at particle 1", "'p0' is 0 N .*wrong are y on 'p0';",
                        p -> gravity(p, 1, 1).force((s, t, f) -> {
                            for (int i = 1; i < p.count(); i++) {
                                f[6 * i + 4] -= p.mass(i) * G;
                            }
                        })),
                wrong("Drag.", "ends before the last particle", "wrong are x, y, z on 'p5';",
                        p -> drag(p, 1, 1, Trait.DISSIPATIVE).force((s, t, f) -> {
                            for (int i = 0; i < p.count() - 1; i++) {
                                push(f, 6 * i, -0.4, s, 6 * i + 3);
                            }
                        })),
                wrong("Gravity.", "one particle too many", "loop|i <", p -> gravity(p, 1, 1).force((s, t, f) -> {
                    for (int i = 0; i <= p.count(); i++) {
                        f[6 * i + 4] -= p.mass(Math.min(i, p.count() - 1)) * G;
                    }
                })),
                wrong("Gravity.", "counts entries as particles", "loop|i <", p -> gravity(p, 1, 1).force((s, t, f) -> {
                    for (int i = 0; i < s.length; i++) {
                        f[6 * i + 4] -= G;
                    }
                })),
                wrong("Gravity.", "four particles are expected", "wrong are y on 'p5'|loop", p -> gravity(p, 1, 1)
                        .force((s, t, f) -> {
                            for (int i = 0; i < 4; i++) {
                                f[6 * i + 4] -= p.mass(i) * G;
                            }
                        })),
                wrong("Drag.", "six particles are expected",
                        "wrong are x, y, z on 'p6', 'p7', 'p8'", p -> drag(p, 1, 1, Trait.DISSIPATIVE)
                        .force((s, t, f) -> {
                            for (int i = 0; i < 6; i++) {
                                push(f, 6 * i, -0.4, s, 6 * i + 3);
                            }
                        })),
                wrong("Gravity.", "all of it in every range", "range", p -> new InRanges(p, true, 0)),
                wrong("Gravity.", "the last of each range left out", "range|loop", p -> new InRanges(p, false, 1)),
                wrong("Gravity.", "set and not added",
                        "^state: component y of the force on particle 'p0' is set and not"
                        + " added .= instead of", p -> gravity(p, 1, 1).force(each(p,
                        (s, f, x, m) -> f[x + 4] = -m * G))),
                wrong("Drag.", "y forgotten", "wrong are y on", p -> drag(p, 1, 1, Trait.DISSIPATIVE).force(each(p,
                        (s, f, x, m) -> {
                            f[x + 3] -= 0.4 * s[x + 3];
                            f[x + 5] -= 0.4 * s[x + 5];
                        }))),
                wrong("Gravity.", "along z", "wrong are y, z on", p -> gravity(p, 1, 1).force(each(p, (s, f, x, m)
                        -> f[x + 5] -= m * G))),
                wrong("Noise.", "random", "random", p -> law("Noise").force(each(p, (s, f, x, m)
                        -> f[x + 3] += random.nextDouble()))),
                wrong("Drag.", "changes the velocities itself", "changes the state", p -> drag(p, 1, 1,
                        Trait.DISSIPATIVE).force(each(p, (s, f, x, m) -> s[x + 3] *= 0.9))),
                wrong("Drag.", "forces kept from call to call", "kept|call", p -> drag(p, 1, 1, Trait.DISSIPATIVE)
                        .force((s, t, f) -> {
                            for (int k = 3; k < f.length; k += k % 6 == 5 ? 4 : 1) {
                                kept[k] -= 0.4 * s[k];
                                f[k] += kept[k];
                            }
                        })),
                wrong("Friction.", "0/0 at rest", "division by 0", p -> law("Friction", Trait.DISSIPATIVE).moving()
                        .force(each(p, (s, f, x, m) -> push(f, x, -m / Math.sqrt(square(s, x + 3)), s, x + 3)))),
                wrong("Gravity.", "nothing written yet", "no force", Nothing::new));
    }

    private static List<EffectSpecimen> pairsOfParticles() {
        return List.of(
                wrong("Springs between neighbours.", "partner forgotten",
                        "the force on 'p0' .* by 14.32 N .* the one on 'p1' by 0 N",
                        p -> law("Chain", Trait.INTERNAL, Trait.CONSERVATIVE).force((s, t, f) -> {
                            for (int x = 0; x + 6 < s.length; x += 6) {
                                double size = 20 - 16 / Law.distance(s, x, x + 6);
                                for (int k = x; k < x + 3; k++) {
                                    f[k + 3] += size * (s[k + 6] - s[k]);
                                }
                            }
                        }).energy((s, t) -> RightEffects.chainEnergy(p, s, 20, 0.8, false))),
                wrong("Attraction", "partner pushed the same way",
                        "by -0.2120 N .* by 0.2120 N", p -> law("Attraction", Trait.INTERNAL,
                        Trait.CONSERVATIVE).force(pairs(p, 1, (r, mm) -> mm / (r * r)))
                        .energy(pairEnergy(p, (r, mm) -> -mm / r))),
                wrong("Attraction", "each pair twice", "is 2 times that", p -> law("Attraction", Trait.INTERNAL,
                        Trait.CONSERVATIVE).force(pairs(p, -1, (r, mm) -> 2 * mm / (r * r)))
                        .energy(pairEnergy(p, (r, mm) -> -mm / r))),
                wrong("N-body", "each asks itself too", "division by 0", p -> law("NBody", Trait.INTERNAL)
                        .force(own(p, 0, true, (r, mm) -> mm / (r * r)))),
                wrong("N-body", "only those after it", "F_ji has to be -F_ij", p -> law("NBody", Trait.INTERNAL,
                        Trait.CONSERVATIVE).force(own(p, -1, false, (r, mm) -> mm / (r * r)))
                        .energy(pairEnergy(p, (r, mm) -> -mm / r))),
                wrong("N-body", "begins at particle 1", "'p0'", p -> law("NBody", Trait.INTERNAL, Trait.CONSERVATIVE)
                        .force(own(p, 1, false, (r, mm) -> mm / (r * r)))
                        .energy(pairEnergy(p, (r, mm) -> -mm / r))),
                wrong("N-body", "the other mass only", "F_ji has to be -F_ij", p -> law("NBody", Trait.INTERNAL,
                        Trait.CONSERVATIVE).force((s, t, f) -> {
                            double[] sum = new double[f.length];
                            own(p, 0, false, (r, mm) -> mm / (r * r)).add(s, t, sum);
                            for (int k = 0; k < f.length; k++) {
                                f[k] += sum[k] / p.mass(k / 6);
                            }
                        }).energy(pairEnergy(p, (r, mm) -> -mm / r))));
    }

    /** As the skeleton is before anything is filled in. */
    private static final class Nothing extends ParticleForce {
        Nothing(Particles particles) {
            super(particles);
        }

        @Override
        protected Vector3 getForce(Vector3 position, Vector3 velocity, double mass, double time) {
            return Vector3.ZERO;
        }
    }

    /** Gravity for several threads. */
    record InRanges(Particles particles, boolean everywhere, int leftOut) implements PerParticleEffect {
        @Override
        public String getName() {
            return "gravity";
        }

        @Override
        public Set<Trait> getTraits() {
            return Set.of(Trait.CONSERVATIVE, Trait.TRANSLATION_INVARIANT);
        }

        @Override
        public void addForces(double[] state, double time, double[] force, int from, int to) {
            for (int i = everywhere ? 0 : from; i < (everywhere ? particles.count() : to - leftOut); i++) {
                force[6 * i + 4] -= G * particles.mass(i);
            }
        }

        @Override
        public double getPotentialEnergy(double[] state, double time) {
            return sum(particles, (s, x, m) -> m * G * s[x + 1]).of(state, time);
        }
    }
}
