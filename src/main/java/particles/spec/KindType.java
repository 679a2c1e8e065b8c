package particles.spec;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.snakeyaml.engine.v2.nodes.MappingNode;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.NodeTuple;
import org.snakeyaml.engine.v2.nodes.ScalarNode;
import org.snakeyaml.engine.v2.nodes.Tag;
import particles.spec.Kind.Chosen;
import particles.spec.messages.Wording;

/**
 * The type of an entry that names a kind: {@code gravity: {acceleration: [0, -9.81, 0]}}, or just {@code gravity} if it
 * needs no keys.
 *
 * @param what  the common name of the kinds, such as {@code effect}
 * @param kinds the kinds, with different names
 * @param own   their class, if {@link ClassNames} finds others by the names of classes
 * @param <K>   the common class of the kinds
 */
public record KindType<K extends Kind>(String what, List<K> kinds, Optional<Class<K>> own)
        implements Type<Chosen<K>> {
    /** The type of the names of classes. */
    static final TextType CLASS = ClassNames.form("exercises.MyForce");

    /** Kinds with different names, without others. */
    public KindType(String what, List<K> kinds) {
        this(what, kinds, Optional.empty());
    }

    /** @return a key for a list of such entries, which is empty if the key is absent */
    public Key<List<Chosen<K>>> list(String name, String sentence) {
        return ListType.of(article(what), this).withDefault(name, List.of(), sentence);
    }

    @Override
    public Optional<Chosen<K>> read(Node node, String label, Reading in) {
        if (node instanceof ScalarNode name && node.getTag().equals(Tag.STR)) {
            return find(name, in).flatMap(kind -> kind.mayBeEmpty()
                    ? Optional.of(new Chosen<>(kind, new Values(in.place(node)), in.place(node)))
                    : in.problem(node, kind.getLabel() + " needs a value for at least one key: write '- "
                            + kind.getName() + ": " + kind.example() + "'"));
        }
        if (!(node instanceof MappingNode mapping) || mapping.getValue().isEmpty()) {
            return wrong(node, label, in);
        }
        return mapping.getValue().get(0).getKeyNode() instanceof ScalarNode name
                ? find(name, in).flatMap(kind -> readKeys(kind, mapping.getValue(), in))
                : wrong(mapping.getValue().get(0).getKeyNode(), label, in);
    }

    private Optional<Chosen<K>> readKeys(K kind, List<NodeTuple> entries, Reading in) {
        Node name = entries.get(0).getKeyNode();
        Node value = entries.get(0).getValueNode();
        if (entries.size() > 1) {
            return in.problem(entries.get(1).getKeyNode(), "an entry names one " + what + ", here " + kind.getLabel()
                    + "; the next line is either one of its keys, indented further, or another " + what
                    + ", which needs its own dash");
        }
        if (value.getTag().equals(Tag.NULL)) {
            return in.problem(name, kind.getLabel() + " has no value; it has to be " + kind.describe()
                    + (kind.mayBeEmpty() ? "; or write '- " + kind.getName() + "', without the colon" : ""));
        }
        return kind.read(value, kind.getLabel(), in).map(values -> new Chosen<>(kind, values, in.place(name)));
    }

    private Optional<K> find(ScalarNode node, Reading in) {
        String name = node.getValue();
        if (own.isPresent() && CLASS.matches(name)) {
            try {
                return Optional.of(in.classes().find(name, own.get()));
            } catch (IllegalArgumentException e) {
                return in.problem(node, e.getMessage());
            }
        }
        return named(name, kinds).or(() -> in.problem(node, unknown(name, in)));
    }

    /** Tells where a kind of another list belongs, such as an effect among the rules. */
    private String unknown(String name, Reading in) {
        for (Key<?> key : in.format().map(MappingType::getKeys).orElse(List.of())) {
            if (key.type() instanceof ListType<?> list && list.element() instanceof KindType<?> other
                    && named(name, other.kinds).isPresent()) {
                return "'" + name + "' is " + article(other.what) + ", not " + article(what) + "; move it to '"
                        + key.name() + "'";
            }
        }
        return Wording.unknown(what, name, names(), in.owners(name));
    }

    private static <N extends Kind> Optional<N> named(String name, List<N> kinds) {
        return kinds.stream().filter(kind -> kind.getName().equals(name)).findFirst();
    }

    private List<String> names() {
        return kinds.stream().map(Kind::getName).toList();
    }

    private static String article(String what) {
        return ("aeiou".indexOf(what.charAt(0)) < 0 ? "a " : "an ") + what;
    }

    @Override
    public String describe() {
        return "one of " + String.join(", ", names()) + orClass() + ", with its keys below it";
    }

    /** @return the alternative to a kind's name, as text to follow the names */
    public String orClass() {
        return own.isPresent() ? ", or " + CLASS.describe() : "";
    }

    @Override
    public Stream<MappingType> mappings() {
        return kinds.stream().flatMap(Kind::mappings);
    }
}
