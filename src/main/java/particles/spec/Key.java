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
    /** @return the default as a JSON value, if there is one */
    public Optional<Object> defaultJson() {
        return defaultValue.map(type::toJson);
    }
}
