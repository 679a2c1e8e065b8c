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

    public static final Key<String> FROM = Key.required("from", ANY_ID, "The particle where the spring begins.");
    public static final Key<String> TO = Key.required("to", ANY_ID, "The particle where it ends.");
    static final Key<Double> STIFFNESS = Key.required("stiffness", NumberType.positive("N/m"),
            "k, the force per metre of stretch (N/m).");
    static final Key<Double> REST_LENGTH = Key.optional("restLength", NumberType.notNegative("m"),
            "l, the length at which it exerts no force (m); by default the initial distance.");
    static final Key<Double> DAMPING = Key.withDefault("damping", NumberType.notNegative("N s/m"), 0.0,
            "k_d, the force per m/s of stretching (N s/m).");

    public static final MappingType TYPE = MappingType.of("a spring", FROM, TO, STIFFNESS, REST_LENGTH, DAMPING);

    /** @return the spring with these values */
    public static SpringDescription of(Values values) {
        return new SpringDescription(values.get(FROM), values.get(TO), values.get(STIFFNESS), values.find(REST_LENGTH),
                values.get(DAMPING), values.getPlace());
    }
}
