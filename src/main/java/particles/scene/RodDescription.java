package particles.scene;

import particles.spec.Key;
import particles.spec.MappingType;
import particles.spec.Place;
import particles.spec.Values;

/**
 * One rigid rod of a scene, as long as the initial distance.
 *
 * @param from  the id of the particle where it begins
 * @param to    the id of the particle where it ends
 * @param place where the scene says so
 */
public record RodDescription(String from, String to, Place place) {
    static final Key<String> FROM = Key.required("from", SpringDescription.ANY_ID, "The particle where the rod begins.");
    static final Key<String> TO = Key.required("to", SpringDescription.ANY_ID, "The particle where it ends.");
    static final MappingType TYPE = MappingType.of("a rod", FROM, TO);

    static RodDescription of(Values values) {
        return new RodDescription(values.get(FROM), values.get(TO), values.place());
    }
}
