package particles.scene.parts;

import java.util.Optional;
import particles.law.Vector3;
import particles.spec.FlagType;
import particles.spec.Key;
import particles.spec.MappingType;
import particles.spec.NumberType;
import particles.spec.TextType;
import particles.spec.Values;
import particles.spec.VectorType;
import particles.spec.messages.Place;

/**
 * One particle of a scene.
 *
 * @param id       its name
 * @param position x (m)
 * @param mass     m (kg)
 * @param fixed    whether it is fixed
 * @param values   the values of its keys, or of its shape's, which are called the same
 * @param place    its place in the file
 */
public record ParticleDescription(String id, Vector3 position, double mass, boolean fixed, Values values,
        Place place) {
    /** Safe in CSV files, and never equal to the id of a shape's particle, which has brackets. */
    static final TextType NEW_ID = TextType.of(
            "a name of at most 60 characters without spaces, brackets, commas, quotes and invisible characters",
            "^[^\\s\\[\\],\"'\\x00-\\x1f\\x7f-\\xa0\\xad\\u061c\\u200b-\\u200f\\u2028-\\u202e"
            + "\\u2060-\\u206f\\ufeff]{1,60}$");

    public static final Key<String> ID = NEW_ID.required("id",
            "The particle's name; it must differ from the ids of other particles and shapes.");
    static final Key<Vector3> POSITION = VectorType.of("m").required("position", "Its position at the start (m).");
    public static final Key<Vector3> VELOCITY = VectorType.of("m/s").withDefault("velocity", Vector3.ZERO,
            "Its velocity at the start (m/s).");
    static final Key<Double> MASS = NumberType.positive("kg").withDefault("mass", 1.0, "Its mass (kg).");
    static final Key<Boolean> FIXED = FlagType.FLAG.withDefault("fixed", false,
            "true: forces do not move it. A rule such as 'circle' still can.");

    static final Key<Double> RADIUS = NumberType.positive("m").optional("radius",
            "The radius of a ball (m), drawn and used by 'repulsion' and 'collisions'; by default that of all others.");

    public static final MappingType TYPE = MappingType.of("a particle", ID, POSITION, VELOCITY, MASS, FIXED, RADIUS);

    /** @return the particle with these values */
    public static ParticleDescription of(Values values) {
        return new ParticleDescription(values.get(ID), values.get(POSITION), values.get(MASS), values.get(FIXED),
                values, values.getPlace());
    }

    /** @return v at the start (m/s); 0 if it is fixed */
    public Vector3 velocity() {
        return fixed ? Vector3.ZERO : values.get(VELOCITY);
    }

    /** @return the radius of its ball (m), if it has one of its own */
    public Optional<Double> radius() {
        return values.find(RADIUS);
    }
}
