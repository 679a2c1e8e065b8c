package particles.spec;

import java.util.Optional;

/**
 * A key of a mapping: its name, type, default and description. {@link Type} makes keys.
 *
 * @param name         its name in the file
 * @param type         the type of its value
 * @param required     whether it must be given
 * @param defaultValue the value if the key is absent; empty if the sentence explains the default
 * @param sentence     its meaning, in one sentence
 * @param <T>          the Java class of its values
 */
public record Key<T>(String name, Type<T> type, boolean required, Optional<T> defaultValue, String sentence) {

    // Written out because a record's own equals is linked at run time, which takes several per cent of a short run.

    @Override
    public boolean equals(Object other) {
        return this == other || other instanceof Key<?> key && name.equals(key.name) && type.equals(key.type)
                && required == key.required && defaultValue.equals(key.defaultValue) && sentence.equals(key.sentence);
    }

    /** Uses the name alone, since the keys of a mapping differ in their names. */
    @Override
    public int hashCode() {
        return name.hashCode();
    }

    /** @return the default as a JSON value, if there is one */
    public Optional<Object> defaultJson() {
        return defaultValue.map(type::toJson);
    }
}
