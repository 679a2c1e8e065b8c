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
 * @param <T> the Java class of an element
 */
public final class ListType<T> extends Type<List<T>> {
    private final String elementName;
    private final Type<T> element;
    final boolean bareAllowed;

    private ListType(String elementName, Type<T> element, boolean bareAllowed) {
        this.elementName = elementName;
        this.element = element;
        this.bareAllowed = bareAllowed;
    }

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
    Optional<List<T>> read(Node node, String what, Reading in) {
        List<T> elements = new ArrayList<>();
        if (node instanceof SequenceNode) {
            for (Node item : ((SequenceNode) node).getValue()) {
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

    /** @return the type of the elements */
    public Type<T> getElement() {
        return element;
    }

    @Override
    Object toJson(List<T> value) {
        return value.stream().map(element::toJson).toList();
    }
}
