package particles.effects;

import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import particles.law.ConstantForce;
import particles.law.DifferentiableEffect;
import particles.law.Particles;
import particles.law.Vector3;
import particles.spec.Key;
import particles.spec.ListType;
import particles.spec.TextType;
import particles.spec.Values;
import particles.spec.VectorType;

/**
 * A constant force on some particles, the same for any mass:
 * <pre>
 *   F = constant
 * </pre>
 * Potential energy -F . x on each of them, zero at the origin.
 */
public final class Push implements ConstantForce, DifferentiableEffect {
    private final Particles particles;
    private final Set<String> pushed;
    private final Vector3 force;

    /**
     * @param particles all particles
     * @param pushed    the ids of those that are pushed
     * @param force     F (N)
     * @throws IllegalArgumentException if F is not finite
     */
    public Push(Particles particles, Set<String> pushed, Vector3 force) {
        this.particles = particles;
        this.pushed = pushed;
        this.force = force.requireFinite("push");
    }

    @Override
    public String getName() {
        return "push";
    }

    @Override
    public Set<Trait> getTraits() {
        return Set.of(Trait.CONSERVATIVE, Trait.TRANSLATION_INVARIANT);
    }

    @Override
    public void addForces(double[] state, double time, double[] forces, int from, int to) {
        for (int i = from, v = Particles.STRIDE * from + 3; i < to; i++, v += Particles.STRIDE) {
            if (isPushed(i)) {
                Vector3.at(forces, v).plus(force).put(forces, v);
            }
        }
    }

    private boolean isPushed(int i) {
        return pushed.contains(particles.id(i));
    }

    /** {@inheritDoc} Fixed particles, which cannot move, are left out. */
    @Override
    public double getPotentialEnergy(double[] state, double time) {
        return 0 - particles.sumOfFree(i -> isPushed(i) ? force.dot(Vector3.at(state, Particles.STRIDE * i)) : 0);
    }

    /** A push in scenes. */
    public static final class Keys extends EffectKind {
        private static final Key<Vector3> FORCE = VectorType.of("N").required("force",
                "F, the force on each of these particles (N).");
        private static final Key<List<String>> PARTICLES = ListType.oneOrMore("a particle", TextType.of(
                "the id of a particle or shape, such as bob or cloth[3,4]", "\\S")).withDefault("particles", List.of(),
                "The particles, or shapes, that it pushes; by default all that are there at the start.");

        /** Called once, by {@link EffectCatalog}. */
        public Keys() {
            super("push", "A constant force on some particles, whatever their mass.", FORCE, PARTICLES);
        }

        @Override
        public void build(Values values, EffectContext scene) {
            List<String> named = values.get(PARTICLES);
            scene.add(new Push(scene.particles(), IntStream.range(0, scene.particles().count())
                    .mapToObj(scene.particles()::id).filter(id -> named.isEmpty() || named.contains(id)
                    || named.contains(id.split("\\[")[0])).collect(Collectors.toSet()), values.get(FORCE)));
        }

        @Override
        public List<String> particles(Values values) {
            return values.list(PARTICLES);
        }

        @Override
        public boolean isRepeatable() {
            return true;
        }
    }
}
