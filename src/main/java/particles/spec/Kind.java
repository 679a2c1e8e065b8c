package particles.spec;

import java.util.List;
import java.util.Optional;
import particles.spec.messages.Place;

/** A named kind of list entry, a mapping with its own keys: an effect, a rule, a shape, a wire. */
public abstract class Kind extends MappingType {
    private final String name;

    /**
     * @param name     the name by which scenes choose it
     * @param sentence a description in one sentence
     * @param keys     the keys that a scene can set
     */
    protected Kind(String name, String sentence, Key<?>... keys) {
        this(name, sentence, List.of(keys), List.of());
    }

    /** As above, with the condition that exactly one of some keys is given. */
    protected Kind(String name, String sentence, List<Key<?>> keys, List<Key<?>> exactlyOneOf) {
        super("'" + name + "'", sentence, keys, exactlyOneOf, Optional.empty());
        this.name = name;
    }

    /** @return the name by which scenes choose it */
    public final String getName() {
        return name;
    }

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
}
