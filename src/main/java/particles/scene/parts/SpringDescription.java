package particles.scene.parts;

import java.util.Optional;
import particles.spec.Key;
import particles.spec.MappingType;
import particles.spec.NumberType;
import particles.spec.TextType;
import particles.spec.Values;
import particles.spec.messages.Place;

/**
 * One spring of a scene.
 *
 * @param from       the id of the particle at its first end
 * @param to         the id of the particle at its second end
 * @param stiffness  k (N/m)
 * @param restLength l (m); the initial distance if the scene does not say
 * @param damping    k_d (N s/m)
 * @param place      its place in the file
 */
public record SpringDescription(String from, String to, double stiffness, Optional<Double> restLength, double damping,
        Place place) {
    /** Refers to a particle that stands alone, or in a shape. */
    public static final TextType ANY_ID = TextType.of("the id of a particle, such as bob or cloth[3,4]",
            "^[^\\s\\[\\],\"'\\x00-\\x1f\\x7f]{1,60}(\\[[0-9]+(,[0-9]+)*\\])?$");

    public static final Key<String> FROM = ANY_ID.required("from", "The particle where it begins.");
    public static final Key<String> TO = ANY_ID.required("to", "The particle where it ends.");
    static final Key<Double> STIFFNESS = NumberType.positive("N/m").required("stiffness",
            "k, the force per metre of stretch (N/m).");
    static final Key<Double> REST_LENGTH = NumberType.notNegative("m").optional("restLength",
            "l, the length at which it exerts no force (m); by default the initial distance.");
    static final Key<Double> DAMPING = NumberType.notNegative("N s/m").withDefault("damping", 0.0,
            "k_d, the force per m/s of stretching (N s/m).");

    public static final MappingType TYPE = MappingType.of("a spring", FROM, TO, STIFFNESS, REST_LENGTH, DAMPING);

    /** @return the spring with these values */
    public static SpringDescription of(Values values) {
        return new SpringDescription(values.get(FROM), values.get(TO), values.get(STIFFNESS), values.find(REST_LENGTH),
                values.get(DAMPING), values.getPlace());
    }
}
