package particles.effects;

import java.util.Set;
import particles.law.ConstantForce;
import particles.law.DifferentiableEffect;
import particles.law.Particles;
import particles.law.Vector3;
import particles.spec.Key;
import particles.spec.Values;
import particles.spec.VectorType;

/**
 * Uniform gravity, the slides' "gravitational acceleration rule", on every particle
 * <pre>
 *   F = m g
 * </pre>
 * Potential energy -m g . x, zero at the origin. Source: COMPSCI 715 (2003), slides "A Particle System" and
 * "Mass-Spring System (cont'd)".
 */
public final class Gravity implements ConstantForce, DifferentiableEffect {
    private final Particles particles;
    private final Vector3 g;

    /**
     * @param particles the particles that fall
     * @param g         the acceleration of free fall (m/s&sup2;), such as (0, -9.81, 0)
     * @throws IllegalArgumentException if g is not finite
     */
    public Gravity(Particles particles, Vector3 g) {
        this.particles = particles;
        this.g = g.requireFinite("gravity");
    }

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
        for (int i = from, v = 6 * from + 3; v < 6 * to; i++, v += 6) {
            double mass = particles.mass(i);
            force[v] += mass * g.x();
            force[v + 1] += mass * g.y();
            force[v + 2] += mass * g.z();
        }
    }

    /** {@inheritDoc} Fixed particles, which cannot fall, are left out. */
    @Override
    public double getPotentialEnergy(double[] state, double time) {
        double energy = 0;
        for (int i = 0; i < particles.count(); i++) {
            if (!particles.isFixed(i)) {
                energy -= particles.mass(i) * g.dot(Vector3.at(state, 6 * i));
            }
        }
        return energy;
    }

    /** The keys of gravity in scenes. */
    public static final class Keys extends EffectKind {
        private static final Key<Vector3> ACCELERATION = VectorType.of("m/s^2").withDefault("acceleration",
                new Vector3(0, -9.81, 0), "g, the acceleration of free fall (m/s^2).");

        /** Called once, by {@link EffectCatalog}. */
        public Keys() {
            super("gravity", "The same acceleration for every particle.", ACCELERATION);
        }

        @Override
        public void build(Values values, EffectContext scene) {
            scene.add(new Gravity(scene.particles(), values.get(ACCELERATION)));
            scene.noteAcceleration(values.get(ACCELERATION));      // for the energy scale of a scene at rest
        }
    }
}
