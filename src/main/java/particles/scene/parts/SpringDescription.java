package particles.scene.parts;

import particles.reactions.RigidConstraints;
import particles.spec.FlagType;
import particles.spec.Key;
import particles.spec.MappingType;
import particles.spec.NumberType;
import particles.spec.TextType;

/** The keys of springs; of rods, which have the same ends; and of how rods and wires are enforced. */
public final class SpringDescription {
    private SpringDescription() {
    }

    /** Refers to a particle that stands alone, or in a shape. */
    public static final TextType ANY_ID = TextType.of("the id of a particle, such as bob or cloth[3,4]",
            "^[^\\s\\[\\],\"'\\x00-\\x1f\\x7f]{1,60}(\\[[0-9]+(,[0-9]+)*\\])?$");

    public static final Key<String> FROM = ANY_ID.required("from", "The particle where it begins.");
    public static final Key<String> TO = ANY_ID.required("to", "The particle where it ends.");
    public static final Key<Double> STIFFNESS = NumberType.positive("N/m").required("stiffness",
            "k, the force per metre of stretch (N/m).");
    public static final Key<Double> REST_LENGTH = NumberType.notNegative("m").optional("restLength",
            "l, the length at which it exerts no force (m); by default the initial distance.");
    public static final Key<Double> DAMPING = NumberType.notNegative("N s/m").withDefault("damping", 0.0,
            "k_d, the force per m/s of stretching (N s/m).");

    public static final MappingType TYPE = MappingType.of("a spring", FROM, TO, STIFFNESS, REST_LENGTH, DAMPING);

    public static final Key<Double> FEEDBACK = NumberType.notNegative("1/s").withDefault("feedback",
            RigidConstraints.USUAL_FEEDBACK,
            "The rate at which errors of length decay (1/s); values far above 0.1/deltaT make the run less accurate.");
    public static final Key<Boolean> PROJECTION = FlagType.FLAG.withDefault("projection", false,
            "true: after every step, particles are moved so that rods have their exact length and beads are"
            + " on their wires.");
}
