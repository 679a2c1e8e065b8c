package particles.teaching.collection;

import static particles.teaching.collection.EffectSpecimen.right;
import static particles.teaching.collection.Law.each;
import static particles.teaching.collection.Law.law;
import static particles.teaching.collection.Law.own;
import static particles.teaching.collection.Law.pairEnergy;
import static particles.teaching.collection.Law.pairs;
import static particles.teaching.collection.Law.push;
import static particles.teaching.collection.Law.square;
import static particles.teaching.collection.Law.sum;

import java.util.List;
import java.util.Set;
import particles.law.Effect;
import particles.law.Effect.Trait;
import particles.law.ParticleForce;
import particles.law.Particles;
import particles.law.Vector3;

/** Right force laws in the styles that students write. */
final class RightEffects {
    private static final Vector3 WIND = new Vector3(2, 0, 1);

    private RightEffects() {
    }

    static List<EffectSpecimen> all() {
        return List.of(
                right("Gravity.", "on one particle", MyGravity::new),
                right("Pulls everything down.", "gravity in ranges", p -> new WrongEffects.InRanges(p, false, 0)),
                right("Gravity", "entry by entry", p -> law("Gravity", Trait.CONSERVATIVE).force((s, t, f) -> {
                    for (int k = 4; k < f.length; k += 6) {
                        f[k] -= 9.81 * p.mass(k / 6);
                    }
                }).energy(sum(p, (s, x, m) -> m * 9.81 * s[x + 1]))),
                right("Gravity along an axis of its own", "downhill", p -> law("slope", Trait.CONSERVATIVE,
                        Trait.TRANSLATION_INVARIANT).force(each(p, (s, f, x, m) -> {
                            f[x + 3] += m * 9.81 * 0.5;
                            f[x + 4] -= m * 9.81 * 0.866;
                        })).energy(sum(p, (s, x, m) -> m * 9.81 * (0.866 * s[x + 1] - 0.5 * s[x])))),
                right("Buoyancy: lifts the particles.", "upwards", p -> law("Buoyancy", Trait.CONSERVATIVE)
                        .force(each(p, (s, f, x, m) -> f[x + 4] += 3)).energy(sum(p, (s, x, m) -> -3 * s[x + 1]))),
                right("Air drag.", "linear drag on one particle", Drag::new),
                right("Drag with the square of the speed", "quadratic drag", p -> law("QuadraticDrag",
                        Trait.DISSIPATIVE).moving()
                        .force(each(p, (s, f, x, m) -> push(f, x, -0.2 * Math.sqrt(square(s, x + 3)), s, x + 3)))
                        .heat(sum(p, (s, x, m) -> 0.2 * Math.pow(square(s, x + 3), 1.5)))),
                right("Drag that differs by axis", "a sledge", p -> law("sledge", Trait.DISSIPATIVE).moving()
                        .force(each(p, (s, f, x, m) -> {
                            f[x + 3] -= 0.1 * s[x + 3];
                            f[x + 5] -= 2 * s[x + 5];
                        })).heat(sum(p, (s, x, m) -> 0.1 * s[x + 3] * s[x + 3] + 2 * s[x + 5] * s[x + 5]))),
                right("Drag in moving air", "wind and drag in one", InWind::new),
                right("Gravity between all particles", "n-body, each pushes itself", p -> nBody(p, false)),
                right("Newton's gravitation", "n-body, fixed ones left out", p -> nBody(p, true)),
                right("Every particle attracts every other.", "n-body by pairs", p -> law("Attraction", Trait.INTERNAL,
                        Trait.CONSERVATIVE, Trait.TRANSLATION_INVARIANT, Trait.ROTATION_INVARIANT)
                        .force(pairs(p, -1, (r, mm) -> mm / (r * r))).energy(pairEnergy(p, (r, mm) -> -mm / r))),
                right("Charges of the same sign repel each other.", "Coulomb", p -> law("Repulsion", Trait.INTERNAL,
                        Trait.CONSERVATIVE).force(pairs(p, -1, (r, mm) -> -2 / (r * r)))
                        .energy(pairEnergy(p, (r, mm) -> 2 / r))),
                right("Lennard-Jones between all pairs", "molecules", p -> law("LennardJones", Trait.INTERNAL,
                        Trait.CONSERVATIVE, Trait.ROTATION_INVARIANT)
                        .force(pairs(p, -1, (r, mm) -> -24 * (2 * Math.pow(r, -13) - Math.pow(r, -7))))
                        .energy(pairEnergy(p, (r, mm) -> 4 * (Math.pow(r, -12) - Math.pow(r, -6))))),
                right("Soft balls that push each other apart", "a force of short range", p -> law("SoftBalls",
                        Trait.INTERNAL, Trait.CONSERVATIVE)
                        .force(pairs(p, -1, (r, mm) -> r < 1.2 ? -8 * (1.2 - r) : 0))
                        .energy(pairEnergy(p, (r, mm) -> r < 1.2 ? 4 * (1.2 - r) * (1.2 - r) : 0))),
                right("Springs from each particle to the next", "a chain", p -> law("Chain", Trait.INTERNAL,
                        Trait.CONSERVATIVE, Trait.TRANSLATION_INVARIANT, Trait.ROTATION_INVARIANT)
                        .force((s, t, f) -> chain(p, s, f, 20, 0.8, 0, false))
                        .energy((s, t) -> chainEnergy(p, s, 20, 0.8, false))),
                right("Damped springs", "a chain with dampers", p -> law("DampedChain", Trait.INTERNAL,
                        Trait.DISSIPATIVE).moving().force((s, t, f) -> chain(p, s, f, 20, 0.8, 0.5, false))
                        .energy((s, t) -> chainEnergy(p, s, 20, 0.8, false)).heat((s, t) -> chainHeat(p, s, 0.5))),
                right("Rubber bands, slack when short", "one-sided springs", p -> law("Rubber", Trait.INTERNAL,
                        Trait.CONSERVATIVE).force((s, t, f) -> chain(p, s, f, 20, 1.2, 0, true))
                        .energy((s, t) -> chainEnergy(p, s, 20, 1.2, true))),
                right("Bends back where three particles are not in line.", "bending, three at a time", p -> law("Beam",
                        Trait.INTERNAL, Trait.CONSERVATIVE, Trait.TRANSLATION_INVARIANT)
                        .force(RightEffects::bend).energy((s, t) -> {
                            double sum = 0;
                            for (int k = 0; k + 12 < s.length; k += k % 6 == 2 ? 4 : 1) {
                                sum += 2 * Math.pow(s[k] - 2 * s[k + 6] + s[k + 12], 2);
                            }
                            return sum;
                        })),
                right("A spring to the origin", "a tether", p -> law("Tether", Trait.CONSERVATIVE,
                        Trait.ROTATION_INVARIANT).force(each(p, (s, f, x, m) -> push(f, x, -4, s, x)))
                        .energy(sum(p, (s, x, m) -> 2 * square(s, x)))),
                right("Pulls towards a sun that does not move.", "a centre", p -> law("Sun", Trait.CONSERVATIVE)
                        .force(each(p, (s, f, x, m) -> push(f, x, -m * Math.pow(square(s, x) + 0.1, -1.5), s, x)))
                        .energy(sum(p, (s, x, m) -> -m / Math.sqrt(square(s, x) + 0.1)))),
                right("Pushes particles away from the origin.", "centrifugal", p -> law("Centrifugal",
                        Trait.CONSERVATIVE).force(each(p, (s, f, x, m) -> push(f, x, 3 * m, s, x)))
                        .energy(sum(p, (s, x, m) -> -1.5 * m * square(s, x)))),
                right("A magnetic field, which does no work", "turns velocities", p -> law("Magnet",
                        Trait.TRANSLATION_INVARIANT).moving().force(each(p, (s, f, x, m) -> {
                            f[x + 3] += 2 * s[x + 4];
                            f[x + 4] -= 2 * s[x + 3];
                        }))),
                right("A floor that pushes back what is below it.", "penalty", p -> law("Floor", Trait.CONSERVATIVE)
                        .force(each(p, (s, f, x, m) -> f[x + 4] += s[x + 1] < 0.5 ? 100 * (0.5 - s[x + 1]) : 0))
                        .energy(sum(p, (s, x, m) -> s[x + 1] < 0.5 ? 50 * (0.5 - s[x + 1]) * (0.5 - s[x + 1]) : 0))),
                right("A wall that pushes back what comes far.", "nothing near the particles", p -> law("Wall",
                        Trait.CONSERVATIVE).force(each(p, (s, f, x, m) -> f[x + 3] += Math.max(0, -10 - s[x])))
                        .energy(sum(p, (s, x, m) -> Math.pow(Math.max(0, -10 - s[x]), 2) / 2))),
                right("Shakes all particles to and fro.", "driven, by the clock", p -> law("Shaker", Trait.DRIVING)
                        .force((s, t, f) -> {
                            for (int k = 3; k < f.length; k += 6) {
                                f[k] += 0.7 * Math.cos(5 * t);
                            }
                        }).driven((s, t) -> {
                            double power = 0;
                            for (int k = 3; k < s.length; k += 6) {
                                power += 0.7 * Math.cos(5 * t) * s[k];
                            }
                            return power;
                        })),
                right("Neighbours drag each other along.", "viscosity", p -> law("Viscosity", Trait.INTERNAL,
                        Trait.DISSIPATIVE, Trait.TRANSLATION_INVARIANT).moving().force((s, t, f) -> {
                            for (int k = 3; k + 6 < f.length; k += k % 6 == 5 ? 4 : 1) {
                                f[k] += 0.6 * (s[k + 6] - s[k]);
                                f[k + 6] -= 0.6 * (s[k + 6] - s[k]);
                            }
                        }).heat((s, t) -> {
                            double sum = 0;
                            for (int k = 3; k + 6 < s.length; k += k % 6 == 5 ? 4 : 1) {
                                sum += 0.6 * (s[k + 6] - s[k]) * (s[k + 6] - s[k]);
                            }
                            return sum;
                        })));
    }

    private static Effect nBody(Particles p, boolean skipFixed) {
        Law.Force all = own(p, 0, false, (r, mm) -> 3 * mm * r / Math.pow(r * r + 0.01, 1.5));
        return law("NBody", Trait.INTERNAL, Trait.CONSERVATIVE, Trait.TRANSLATION_INVARIANT, Trait.ROTATION_INVARIANT)
                .force((s, t, f) -> {
                    double[] sum = new double[f.length];
                    all.add(s, t, sum);
                    for (int k = 0; k < f.length; k++) {
                        f[k] += skipFixed && p.isFixed(k / 6) ? 0 : sum[k];
                    }
                }).energy(pairEnergy(p, (r, mm) -> -3 * mm / Math.sqrt(r * r + 0.01)));
    }

    static void chain(Particles p, double[] s, double[] f, double k, double l, double c, boolean slack) {
        for (int x = 0; x + 6 < s.length; x += 6) {
            double r = Law.distance(s, x, x + 6);
            double rate = 0;
            for (int i = x; i < x + 3; i++) {
                rate += (s[i + 6] - s[i]) * (s[i + 9] - s[i + 3]) / r;
            }
            double size = slack && r < l ? 0 : k * (r - l) + c * rate;
            for (int i = x; i < x + 3; i++) {
                f[i + 3] += size * (s[i + 6] - s[i]) / r;
                f[i + 9] -= size * (s[i + 6] - s[i]) / r;
            }
        }
    }

    static double chainEnergy(Particles p, double[] s, double k, double l, boolean slack) {
        double sum = 0;
        for (int i = 1; i < p.count(); i++) {
            double stretch = Law.distance(s, 6 * i, 6 * i - 6) - l;
            sum += slack && stretch < 0 ? 0 : k * stretch * stretch / 2;
        }
        return sum;
    }

    static double chainHeat(Particles p, double[] s, double c) {
        double sum = 0;
        for (int x = 0; x + 6 < s.length; x += 6) {
            double rate = 0;
            for (int i = x; i < x + 3; i++) {
                rate += (s[i + 6] - s[i]) * (s[i + 9] - s[i + 3]) / Law.distance(s, x, x + 6);
            }
            sum += c * rate * rate;
        }
        return sum;
    }

    private static void bend(double[] s, double t, double[] f) {
        for (int k = 0; k + 12 < s.length; k += k % 6 == 2 ? 4 : 1) {
            double pull = 4 * (s[k] - 2 * s[k + 6] + s[k + 12]);
            f[k + 3] -= pull;
            f[k + 9] += 2 * pull;
            f[k + 15] -= pull;
        }
    }

    /** As the skeleton has it. */
    private static final class MyGravity extends ParticleForce {
        MyGravity(Particles particles) {
            super(particles);
        }

        @Override
        public Set<Trait> getTraits() {
            return Set.of(Trait.CONSERVATIVE);
        }

        @Override
        protected Vector3 getForce(Vector3 position, Vector3 velocity, double mass, double time) {
            return new Vector3(0, -9.81 * mass, 0);
        }

        @Override
        protected double getPotentialEnergy(Vector3 position, double mass, double time) {
            return mass * 9.81 * position.y();
        }
    }

    /** The sum of its heat is the student's own loop. */
    private static final class Drag extends ParticleForce {
        private final Particles particles;

        Drag(Particles particles) {
            super(particles);
            this.particles = particles;
        }

        @Override
        public Set<Trait> getTraits() {
            return Set.of(Trait.DISSIPATIVE);
        }

        @Override
        protected Vector3 getForce(Vector3 position, Vector3 velocity, double mass, double time) {
            return velocity.times(-0.3);
        }

        @Override
        public double getDissipatedPower(double[] state, double time) {
            return sum(particles, (s, x, m) -> 0.3 * square(s, x + 3)).of(state, time);
        }
    }

    /** Drag and wind: what the air takes out and what it puts in. */
    private static final class InWind extends ParticleForce {
        private final Particles particles;

        InWind(Particles particles) {
            super(particles);
            this.particles = particles;
        }

        @Override
        public Set<Trait> getTraits() {
            return Set.of(Trait.DISSIPATIVE, Trait.DRIVING);
        }

        @Override
        protected Vector3 getForce(Vector3 position, Vector3 velocity, double mass, double time) {
            return velocity.minus(WIND).times(-0.3);
        }

        private static Vector3 slip(double[] s, int x) {
            return new Vector3(s[x + 3], s[x + 4], s[x + 5]).minus(WIND);
        }

        @Override
        public double getDissipatedPower(double[] state, double time) {
            return sum(particles, (s, x, m) -> 0.3 * slip(s, x).dot(slip(s, x))).of(state, time);
        }

        @Override
        public double getDrivenPower(double[] state, double time) {
            return sum(particles, (s, x, m) -> -0.3 * slip(s, x).dot(WIND)).of(state, time);
        }
    }
}
