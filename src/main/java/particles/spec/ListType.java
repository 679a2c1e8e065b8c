package particles.spec;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.SequenceNode;

/**
 * The type of a list of values; some lists of one may be written without brackets.
 *
 * @param elementName the name of an element in messages
 * @param element     the type of an element
 * @param bareAllowed whether one element may stand without brackets
 * @param <T>         the Java class of an element
 */
public record ListType<T>(String elementName, Type<T> element, boolean bareAllowed) implements Type<List<T>> {
    /** @return the type of a list of elements, with the name of an element in messages */
    public static <T> ListType<T> of(String elementName, Type<T> element) {
        return new ListType<>(elementName, element, false);
    }

    /** @return the type of a list of elements, or of one element that is not a list itself */
    public static <T> ListType<T> oneOrMore(String elementName, Type<T> element) {
        return new ListType<>(elementName, element, true);
    }

    /**
     * {@inheritDoc} Returns the elements without problems, so that other parts that depend on them can still be
     * checked.
     */
    @Override
    public Optional<List<T>> read(Node node, String what, Reading in) {
        List<T> elements = new ArrayList<>();
        if (node instanceof SequenceNode sequence) {
            for (Node item : sequence.getValue()) {
                if (!in.problems().isFull()) {
                    element.read(item, elementName, in).ifPresent(elements::add);
                }
            }
        } else if (bareAllowed) {
            element.read(node, what, in).ifPresent(elements::add);
        } else {
            return wrong(node, what, in);
        }
        return Optional.of(elements);
    }

    @Override
    public String describe() {
        return bareAllowed ? element.describe() + ", or a list of these" : "a list, each entry after a dash: "
                + element.describe();
    }

    @Override
    public Stream<MappingType> mappings() {
        return element.mappings();
    }

    @Override
    public Object toJson(List<T> value) {
        return value.stream().map(element::toJson).toList();
    }
}
