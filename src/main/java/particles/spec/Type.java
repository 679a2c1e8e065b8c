package particles.spec;

import java.util.Optional;
import java.util.stream.Stream;
import org.snakeyaml.engine.v2.nodes.Node;
import particles.spec.messages.Wording;

/**
 * The type of a key's value: reads and checks it, and describes it.
 *
 * @param <T> the Java class of a value
 */
public interface Type<T> {

    /**
     * Reads a value.
     *
     * @param node the node of the value
     * @param what its name in messages, such as {@code 'mass'}
     * @param in   receives the problems
     * @return the value, or empty if a problem was reported
     */
    Optional<T> read(Node node, String what, Reading in);

    /** @return a key that must be given */
    default Key<T> required(String name, String sentence) {
        return new Key<>(name, this, true, Optional.empty(), sentence);
    }

    /** @return a key with a default */
    default Key<T> withDefault(String name, T defaultValue, String sentence) {
        return new Key<>(name, this, false, Optional.of(defaultValue), sentence);
    }

    /** @return a key that may be absent; its sentence explains the default */
    default Key<T> optional(String name, String sentence) {
        return new Key<>(name, this, false, Optional.empty(), sentence);
    }

    /** @return the values allowed, as text that follows "it has to be": {@code a number over 0 (kg)} */
    String describe();

    /** @return a sample value of this type for trials; empty if there is none */
    default Optional<T> sample() {
        return Optional.empty();
    }

    /** @return all mappings that a value of this type may contain, itself included */
    default Stream<MappingType> mappings() {
        return Stream.empty();
    }

    /**
     * @param value a value of this type
     * @return the value as JSON: a number, text, boolean or list
     */
    default Object toJson(T value) {
        return value;
    }

    /** Adds the problem that a value is not one of those allowed. */
    default Optional<T> wrong(Node node, String what, Reading in) {
        return wrong(node, what, "it has to be " + describe(), in);
    }

    /** As {@link #wrong(Node, String, Reading)}, with another hint. */
    default Optional<T> wrong(Node node, String what, String hint, Reading in) {
        return in.problem(node, what + " is " + Wording.describe(node) + "; " + hint);
    }
}
