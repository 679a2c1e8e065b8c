package particles.effects;

import java.util.BitSet;
import java.util.List;
import java.util.Set;
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
 * A constant force F on some particles, the same for any mass. Potential energy -F . x on each of them, zero at the
 * origin.
 */
public final class Push implements ConstantForce, DifferentiableEffect {
    private final Particles particles;
    private final Vector3 force;
    private BitSet pushed;

    /**
     * @param particles all particles
     * @param pushed    the indices of those that are pushed
     * @param force     F (N)
     * @throws IllegalArgumentException if F is not finite
     */
    public Push(Particles particles, IntStream pushed, Vector3 force) {
        this.particles = particles;
        this.pushed = set(pushed);
        this.force = force.requireFinite("push");
    }

    private static BitSet set(IntStream indices) {
        BitSet set = new BitSet();
        indices.forEach(set::set);
        return set;
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
        for (int i = pushed.nextSetBit(from); i >= 0 && i < to; i = pushed.nextSetBit(i + 1)) {
            int v = Particles.STRIDE * i + 3;
            forces[v] += force.x();
            forces[v + 1] += force.y();
            forces[v + 2] += force.z();
        }
    }

    /** {@inheritDoc} Fixed particles, which cannot move, are left out. */
    @Override
    public double getPotentialEnergy(double[] state, double time) {
        return 0 - particles.sumOfFree(i -> pushed.get(i) ? force.dot(Vector3.at(state, Particles.STRIDE * i)) : 0);
    }

    @Override
    public void reindex(int[] newIndex) {
        pushed = set(pushed.stream().map(i -> newIndex[i]).filter(i -> i >= 0));
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
            List<String> ids = values.get(PARTICLES);
            IntStream pushed = ids.isEmpty() ? IntStream.range(0, scene.particles().count())
                    : ids.stream().flatMapToInt(id -> find(id, scene.particles()));
            scene.add(new Push(scene.particles(), pushed, values.get(FORCE)));
        }

        private static IntStream find(String id, Particles particles) {
            return IntStream.range(0, particles.count()).filter(i -> particles.id(i).equals(id)
                    || particles.id(i).startsWith(id + "["));
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
