package particles.teaching.collection;

import static particles.teaching.collection.EffectSpecimen.wrong;
import static particles.teaching.collection.Law.each;
import static particles.teaching.collection.Law.law;
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
import particles.law.Particles;
import particles.law.PerParticleEffect;

/** Wrong force laws in the styles that students write, each with one mistake; each finding of the check is there. */
final class WrongEffects {
    private static final double G = 9.81;

    private WrongEffects() {
    }

    static List<EffectSpecimen> all() {
        return Stream.of(energies(), claims(), indices(), pairsOfParticles()).flatMap(List::stream).toList();
    }

    static Law gravity(Particles p, double force, double energy) {
        return law(Trait.CONSERVATIVE).force(each(p, (s, f, x, m) -> f[x + 4] -= force * m * G))
                .energy(sum(p, (s, x, m) -> energy * m * G * s[x + 1]));
    }

    static Law drag(Particles p, double heat, Trait... traits) {
        return law(traits).moving().force(each(p, (s, f, x, m) -> push(f, x, -0.4, s, x + 3)))
                .heat(sum(p, (s, x, m) -> 0.4 * heat * square(s, x + 3)));
    }

    private static Law tether(Particles p, double energy, Trait... traits) {
        return law(traits).force(each(p, (s, f, x, m) -> push(f, x, -4, s, x)))
                .energy(sum(p, (s, x, m) -> 2 * energy * square(s, x)));
    }

    private static List<EffectSpecimen> energies() {
        return List.of(
                wrong("gravity upwards",
                        "^method: component y of the force on particle 'p0' is 11.68 N .* -11.68 N;.* is -1 times that",
                        p -> gravity(p, -1, 1)),
                wrong("drag with negative heat", "heat is never negative", p -> drag(p, -1, Trait.DISSIPATIVE)),
                wrong("quadratic drag: v * v has no sign", "at -1 m/s; .*is -1 times that",
                        p -> law(Trait.DISSIPATIVE).moving().force(each(p, (s, f, x, m) -> {
                            for (int k = x + 3; k < x + 6; k++) {
                                f[k] -= 0.2 * s[k] * s[k];
                            }
                        })).heat(sum(p, (s, x, m) -> 0.2 * (Math.pow(Math.abs(s[x + 3]), 3)
                                + Math.pow(Math.abs(s[x + 4]), 3) + Math.pow(Math.abs(s[x + 5]), 3))))),
                wrong("no mass in the force", "'p0' is -9.810 N.*ask for -11.68 N; wrong are y on",
                        p -> gravity(p, 1, 1).force(each(p, (s, f, x, m) -> f[x + 4] -= G))),
                wrong("no energy", "on every particle: one of them is missing", p -> gravity(p, 1, 0)),
                wrong("energy goes with x", "wrong are x, y on 'p0', 'p1', 'p2', 'p3', 'p5'",
                        p -> gravity(p, 1, 1).energy(sum(p, (s, x, m) -> m * G * s[x]))),
                wrong("energy 5/2 times as large", "is 2/5 times that", p -> tether(p, 2.5, Trait.CONSERVATIVE)),
                wrong("twice the heat, and claims to drive", "is 1/2 times that",
                        p -> drag(p, 2, Trait.DISSIPATIVE, Trait.DRIVING)),
                wrong("no driven power", "getDrivenPower",
                        p -> law(Trait.DRIVING).force(each(p, (s, f, x, m) -> f[x + 3] += 0.7))));
    }

    private static List<EffectSpecimen> claims() {
        return List.of(
                wrong("gravity claims INTERNAL", "claims INTERNAL",
                        p -> gravity(p, 1, 1).claiming(Trait.CONSERVATIVE, Trait.INTERNAL)),
                wrong("gravity claims no direction",
                        "claims ROTATION_INVARIANT, and with everything turned alike component",
                        p -> gravity(p, 1, 1).claiming(Trait.CONSERVATIVE, Trait.ROTATION_INVARIANT)),
                wrong("a spring to the origin claims no place", "claims TRANSLATION_INVARIANT, and with",
                        p -> tether(p, 1, Trait.CONSERVATIVE, Trait.TRANSLATION_INVARIANT)),
                wrong("drag claims CONSERVATIVE", "on every particle: .*or a claim is wrong",
                        p -> drag(p, 0, Trait.CONSERVATIVE)),
                wrong("drag claims to conserve and to dissipate", "contradict",
                        p -> drag(p, 1, Trait.CONSERVATIVE, Trait.DISSIPATIVE)),
                wrong("gravity claims to conserve and to drive", "contradict",
                        p -> gravity(p, 1, 1).claiming(Trait.CONSERVATIVE, Trait.DRIVING)),
                wrong("drag says that velocities do not count", "dependsOnVelocity",
                        p -> drag(p, 1, Trait.DISSIPATIVE).still()),
                wrong("drag claims nothing", "claim DISSIPATIVE, or return 0", p -> drag(p, 1)));
    }

    private static List<EffectSpecimen> indices() {
        Random random = new Random(9);
        return List.of(
                wrong("written over the position", "^state: component y of the force on particle 'p0'"
                        + " is written to entry 1, where the position stands",
                        p -> gravity(p, 1, 1).force(each(p, (s, f, x, m) -> f[x + 1] -= m * G))),
                wrong("written over a position later", "written to entry 0, where the position stands",
                        p -> law().force((s, t, f) -> {
                            f[4] -= 1;
                            f[0] += t > 1 ? 1 : 0;
                        })),
                wrong("positions read with stride 3", "on particle 'p1' .*these entries of the state: .3.",
                        p -> tether(p, 1, Trait.CONSERVATIVE)
                        .force(each(p, (s, f, x, m) -> push(f, x, -4, s, x / 2)))),
                wrong("position read for the velocity", "'p0' .*these entries of the state: .0.",
                        p -> drag(p, 1, Trait.DISSIPATIVE).force(each(p, (s, f, x, m) -> push(f, x, -0.4, s, x)))),
                wrong("begins at particle 1", "'p0' is 0 N .*wrong are y on 'p0';",
                        p -> gravity(p, 1, 1).times(i -> i < 1 ? 0 : 1)),
                wrong("six particles are expected", "wrong are x, y, z on 'p6', 'p7', 'p8'",
                        p -> drag(p, 1, Trait.DISSIPATIVE).times(i -> i < 6 ? 1 : 0)),
                wrong("one particle too many", "loop|i <", p -> gravity(p, 1, 1).force((s, t, f) -> {
                    for (int i = 0; i <= p.count(); i++) {
                        f[6 * i + 4] -= p.mass(Math.min(i, p.count() - 1)) * G;
                    }
                })),
                wrong("all of it in every range", "range", p -> new InRanges(p, true, 0)),
                wrong("the last of each range left out", "range|loop", p -> new InRanges(p, false, 1)),
                wrong("set and not added", "^state: component y of the force on particle 'p0' is set and not"
                        + " added .= instead of",
                        p -> gravity(p, 1, 1).force(each(p, (s, f, x, m) -> f[x + 4] = -m * G))),
                wrong("random", "random",
                        p -> law().force(each(p, (s, f, x, m) -> f[x + 3] += random.nextDouble()))),
                wrong("changes the velocities itself", "changes the state",
                        p -> drag(p, 1, Trait.DISSIPATIVE).force(each(p, (s, f, x, m) -> s[x + 3] *= 0.9))),
                wrong("0/0 at rest", "division by 0", p -> law(Trait.DISSIPATIVE).moving()
                        .force(each(p, (s, f, x, m) -> push(f, x, -m / Math.sqrt(square(s, x + 3)), s, x + 3)))),
                wrong("nothing written yet", "no force", p -> law()));
    }

    /** Springs of 20 N/m and 0.8 m between all particles. */
    private static Law springs(Particles p, double partner, double energyLength) {
        return law(Trait.INTERNAL, Trait.CONSERVATIVE).force(pairs(p, partner, (r, mm) -> 20 * (r - 0.8)))
                .energy(pairEnergy(p, (r, mm) -> 10 * (r - energyLength) * (r - energyLength)));
    }

    private static List<EffectSpecimen> pairsOfParticles() {
        return List.of(
                wrong("rest length left out of the energy",
                        "wrong are x, y, z on .*state: .0, 1, 2, 6, 7, 8, 12, 13, 14, 18, 19, 20, ",
                        p -> springs(p, -1, 0)),
                wrong("partner forgotten", "the force on 'p0' .* by 14.32 N .* the one on 'p1' by 0 N",
                        p -> springs(p, 0, 0.8)),
                wrong("partner pushed the same way", "by 14.32 N .* by -14.32 N", p -> springs(p, 1, 0.8)),
                wrong("the other mass only", "F_ji has to be -F_ij",
                        p -> springs(p, -1, 0.8).times(i -> 1 / p.mass(i))));
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
