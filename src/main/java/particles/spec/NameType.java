package particles.spec;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.ScalarNode;
import org.snakeyaml.engine.v2.nodes.Tag;
import particles.spec.messages.Wording;

/**
 * The type of a name from a list, or optionally a text of another form.
 *
 * @param what  the kind of thing that has these names, such as {@code solver}
 * @param names the names
 * @param parse what a name stands for
 * @param other the type of other texts allowed; no name may have their form
 * @param <T>   what the names stand for: themselves, or the constants of an enum
 */
public record NameType<T>(String what, List<String> names, Function<String, T> parse, Optional<TextType> other)
        implements Type<T> {
    /**
     * @param what  the kind of thing that has these names, such as {@code solver}
     * @param names the names
     * @return the type of one of these names
     */
    public static NameType<String> of(String what, List<String> names) {
        return new NameType<>(what, names, Function.identity(), Optional.empty());
    }

    /**
     * @param what the kind of thing that has these names
     * @param type an enum
     * @return the type of its constants, with names such as {@code beside-surfaces}
     */
    public static <E extends Enum<E>> NameType<E> of(String what, Class<E> type) {
        return new NameType<>(what, Arrays.stream(type.getEnumConstants()).map(NameType::nameOf).toList(),
                name -> Enum.valueOf(type, name.toUpperCase(Locale.ROOT).replace('-', '_')), Optional.empty());
    }

    private static String nameOf(Enum<?> constant) {
        return constant.name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    /**
     * @param what  the kind of thing that has these names
     * @param names the names
     * @param other the type of other texts allowed; no name may have their form
     * @return the type of a name, or of a text of the other form
     */
    public static NameType<String> or(String what, List<String> names, TextType other) {
        return new NameType<>(what, names, Function.identity(), Optional.of(other));
    }

    @Override
    public Optional<T> read(Node node, String label, Reading in) {
        if (!(node instanceof ScalarNode scalar)) {
            return wrong(node, label, in);
        }
        String text = scalar.getValue();
        if (node.getTag().equals(Tag.STR)
                && (names.contains(text) || other.filter(form -> form.matches(text)).isPresent())) {
            return Optional.of(parse.apply(text));
        }
        return in.problem(node, Wording.unknown(what, text, names, List.of()) + orOther());
    }

    @Override
    public Optional<T> sample() {
        return names.stream().findFirst().map(parse);
    }

    @Override
    public String describe() {
        return "one of " + String.join(", ", names) + orOther();
    }

    private String orOther() {
        return other.map(form -> ", or " + form.describe()).orElse("");
    }

    @Override
    public Object toJson(T value) {
        return value instanceof Enum<?> constant ? nameOf(constant) : value;
    }
}
