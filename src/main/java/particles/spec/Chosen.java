package particles.spec;

import particles.spec.messages.Place;

/**
 * One entry of a list: the kind that it names, its values and its place.
 *
 * @param kind   the kind
 * @param values what is said of it
 * @param place  where its name stands
 * @param <K>    the kinds there are
 */
public record Chosen<K extends Kind>(K kind, Values values, Place place) {
}
