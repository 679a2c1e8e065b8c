package particles.spec;

import java.util.Optional;

/**
 * A key of a mapping: its name, type, default and description.
 *
 * @param name         how it is written
 * @param type         what values it takes
 * @param required     whether it must be there
 * @param defaultValue the value if the key is absent; empty if the sentence says what absence means
 * @param sentence     what it means
 * @param <T>          what a value is in Java
 */
public record Key<T>(String name, Type<T> type, boolean required, Optional<T> defaultValue, String sentence) {

    /** @return a key that must be there */
    public static <T> Key<T> required(String name, Type<T> type, String sentence) {
        return new Key<>(name, type, true, Optional.empty(), sentence);
    }

    /** @return a key with a default */
    public static <T> Key<T> withDefault(String name, Type<T> type, T defaultValue, String sentence) {
        return new Key<>(name, type, false, Optional.of(defaultValue), sentence);
    }

    /** @return a key that may be absent; the sentence says what that means */
    public static <T> Key<T> optional(String name, Type<T> type, String sentence) {
        return new Key<>(name, type, false, Optional.empty(), sentence);
    }

    // Written out because a record's own equals is linked at run time, which takes several per cent of a short run.

    @Override
    public boolean equals(Object other) {
        return this == other || other instanceof Key<?> key && name.equals(key.name) && type.equals(key.type)
                && required == key.required && defaultValue.equals(key.defaultValue) && sentence.equals(key.sentence);
    }

    /** Uses the name alone, in which the keys of a mapping differ. */
    @Override
    public int hashCode() {
        return name.hashCode();
    }

    /** @return the default as a JSON value, if there is one */
    public Optional<Object> defaultJson() {
        return defaultValue.map(type::toJson);
    }
}
