package particles.effects;

import particles.law.Sphere;
import particles.law.Vector3;
import particles.spec.FlagType;
import particles.spec.Key;
import particles.spec.NumberType;
import particles.spec.TextType;
import particles.spec.Values;
import particles.spec.VectorType;

/** Scene keys that several effects and rules have in common. */
public final class SharedKeys {
    /** Names a particle. */
    public static final TextType PARTICLE = TextType.of("the id of a particle, such as bob or cloth[3,4]", "\\S");
    /** For 'repulsion' and 'collisions': a kind that has this key makes balls of particles, which are drawn so. */
    public static final Key<Double> BALL_RADIUS = NumberType.positive("m").required("radius",
            "The radius of every ball without a radius of its own (m).");
    /** The seed of random numbers. */
    public static final Key<Integer> SEED = new NumberType.Whole(0, 1_000_000_000).withDefault("seed", 1,
            "The seed of the random numbers; the same seed gives the same run on every machine.");

    /** The centre of a sphere or a block. */
    public static final Key<Vector3> CENTRE = VectorType.of("m").required("centre", "Its centre (m).");
    /** The radius of a sphere. */
    public static final Key<Double> RADIUS = NumberType.positive("m").required("radius", "Its radius (m).");
    /** Whether a sphere is a hollow: solid outside, particles inside. */
    public static final Key<Boolean> HOLLOW = FlagType.FLAG.withDefault("hollow", false,
            "true: particles stay inside, as in a bowl or a bubble; false: outside.");

    private SharedKeys() {
    }

    /**
     * @param values a scene's values for a sphere
     * @return the sphere
     */
    public static Sphere sphere(Values values) {
        return new Sphere(values.get(CENTRE), values.get(RADIUS), values.get(HOLLOW));
    }
}
