package particles.spec;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.ScalarNode;
import org.snakeyaml.engine.v2.nodes.Tag;
import particles.spec.messages.Problems;
import particles.spec.messages.Wording;

/** The type of a name from a list, or optionally a text of another form. */
public final class NameType extends Type<String> {
    private final String what;
    private final List<String> names;
    private final Optional<TextType> other;

    private NameType(String what, List<String> names, Optional<TextType> other) {
        this.what = what;
        this.names = List.copyOf(names);
        this.other = other;
    }

    /**
     * @param what  the kind of thing that has these names, such as {@code solver}
     * @param names the names
     * @return the type of one of these names
     */
    public static NameType of(String what, List<String> names) {
        return new NameType(what, names, Optional.empty());
    }

    /**
     * @param what  the kind of thing that has these names
     * @param names the names
     * @param other the type of other texts allowed; no name may have their form
     * @return the type of a name, or of a text of the other form
     */
    public static NameType or(String what, List<String> names, TextType other) {
        return new NameType(what, names, Optional.of(other));
    }

    @Override
    Optional<String> read(Node node, String label, Reading in) {
        if (!(node instanceof ScalarNode)) {
            return wrong(node, label, in);
        }
        String text = ((ScalarNode) node).getValue();
        if (names.contains(text) && isText(node)) {
            return Optional.of(text);
        }
        if (other.isPresent() && isText(node)) {
            Optional<String> read = other.get().read(node, label, new Reading(in.source(), new Problems()));
            if (read.isPresent()) {
                return read;
            }
        }
        return in.problem(node, Wording.unknown(what, text, names, List.of())
                + other.map(o -> ", or " + o.describe()).orElse(""));
    }

    private static boolean isText(Node node) {
        return node.getTag().equals(Tag.STR);
    }

    @Override
    Optional<String> sample() {
        return names.stream().findFirst();
    }

    @Override
    public String describe() {
        return "one of " + String.join(", ", names) + other.map(o -> ", or " + o.describe()).orElse("");
    }

    @Override
    Map<String, Object> schema() {
        Map<String, Object> choice = Ordered.map("enum", names);
        return other.isEmpty() ? choice : Ordered.map("anyOf", List.of(choice, other.get().schema()));
    }
}
