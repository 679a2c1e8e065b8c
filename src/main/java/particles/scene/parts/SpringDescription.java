package particles.scene.parts;

import particles.spec.Key;
import particles.spec.MappingType;
import particles.spec.NumberType;
import particles.spec.TextType;

/** The keys of a spring, of which rods have the ends. */
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
}
