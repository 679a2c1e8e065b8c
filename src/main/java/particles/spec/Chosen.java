package particles.spec;

import particles.spec.messages.Place;

/**
 * One entry of a list in a file: the kind that it names, its values and its place.
 *
 * @param kind   the kind
 * @param values the values of its keys
 * @param place  the place of its name
 * @param <K>    the common class of the kinds
 */
public record Chosen<K extends Kind>(K kind, Values values, Place place) {
}
