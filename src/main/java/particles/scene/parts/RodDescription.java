package particles.scene.parts;

import particles.spec.Key;
import particles.spec.MappingType;
import particles.spec.Values;
import particles.spec.messages.Place;

/**
 * One rigid rod of a scene; its length is the initial distance of its ends.
 *
 * @param from  the id of the particle at its first end
 * @param to    the id of the particle at its second end
 * @param place its place in the file
 */
public record RodDescription(String from, String to, Place place) {
    public static final Key<String> FROM = SpringDescription.ANY_ID.required("from",
            "The particle where the rod begins.");
    public static final Key<String> TO = SpringDescription.ANY_ID.required("to", "The particle where it ends.");
    public static final MappingType TYPE = MappingType.of("a rod", FROM, TO);

    /** @return the rod with these values */
    public static RodDescription of(Values values) {
        return new RodDescription(values.get(FROM), values.get(TO), values.getPlace());
    }
}
