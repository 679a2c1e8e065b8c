package particles.spec;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.snakeyaml.engine.v2.nodes.MappingNode;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.NodeTuple;
import org.snakeyaml.engine.v2.nodes.ScalarNode;
import org.snakeyaml.engine.v2.nodes.Tag;
import particles.spec.messages.Place;
import particles.spec.messages.Wording;

/**
 * The type of an entry that names a kind: {@code gravity: {acceleration: [0, -9.81, 0]}}, or just {@code gravity} if it
 * needs no keys.
 *
 * @param <K> the common class of the kinds
 */
public final class KindType<K extends Kind> extends Type<Chosen<K>> {
    private final String what;
    private final List<K> kinds;
    final Optional<ByClass<K>> byClass;
    private final Optional<Elsewhere> elsewhere;

    /** Kinds of another list, to recognise mistakes such as an effect among the rules. */
    private record Elsewhere(String what, String key, List<? extends Kind> kinds) {
    }

    record ByClass<K extends Kind>(Class<K> type, TextType form) {
    }

    /**
     * @param what  the common name of the kinds, such as {@code effect}
     * @param kinds the kinds, with different names
     */
    public KindType(String what, List<K> kinds) {
        this(what, kinds, Optional.empty(), Optional.empty());
    }

    private KindType(String what, List<K> kinds, Optional<ByClass<K>> byClass, Optional<Elsewhere> elsewhere) {
        this.elsewhere = elsewhere;
        this.what = what;
        this.kinds = List.copyOf(kinds);
        this.byClass = byClass;
    }

    /**
     * @param type    a sort of kinds
     * @param example the name of a class that declares one
     * @return these kinds, and besides them all that {@link ClassNames} finds by the name of a class
     */
    public KindType<K> orByClass(Class<K> type, String example) {
        return new KindType<>(what, kinds, Optional.of(new ByClass<>(type, ClassNames.form(example))), elsewhere);
    }

    /**
     * @param otherWhat the common name of other kinds, such as {@code effect}
     * @param key       the key of their list, such as {@code effects}
     * @param others    the other kinds, with other names
     * @return this type; for a name of another kind the message says where it belongs
     */
    public KindType<K> notToConfuseWith(String otherWhat, String key, List<? extends Kind> others) {
        return new KindType<>(what, kinds, byClass, Optional.of(new Elsewhere(otherWhat, key, others)));
    }

    @Override
    Optional<Chosen<K>> read(Node node, String label, Reading in) {
        if (node instanceof ScalarNode && node.getTag().equals(Tag.STR)) {
            return find(node, in).flatMap(kind -> bare(kind, node, in));
        }
        if (!(node instanceof MappingNode) || ((MappingNode) node).getValue().isEmpty()) {
            return wrong(node, label, in);
        }
        List<NodeTuple> entries = ((MappingNode) node).getValue();
        Node nameNode = entries.get(0).getKeyNode();
        if (!(nameNode instanceof ScalarNode)) {
            return wrong(nameNode, label, in);
        }
        Optional<K> kind = find(nameNode, in);
        if (kind.isEmpty()) {
            return Optional.empty();
        }
        if (entries.size() > 1) {
            return in.problem(entries.get(1).getKeyNode(), "an entry names one " + what + ", here '"
                    + kind.get().getName() + "'; the next line is either one of its keys, indented further, or another "
                    + what
                    + ", which needs its own dash");
        }
        Node valueNode = entries.get(0).getValueNode();
        if (valueNode.getTag().equals(Tag.NULL)) {
            return in.problem(nameNode,
                    "'" + kind.get().getName() + "' has no value; it has to be " + kind.get().describe()
                    + (kind.get().mayBeEmpty() ? "; or write '- " + kind.get().getName()
                    + "', without the colon" : ""));
        }
        Place place = in.place(nameNode);
        return kind.get().read(valueNode, "'" + kind.get().getName() + "'",
                in).map(values -> new Chosen<>(kind.get(),
                values, place));
    }

    private Optional<K> find(Node nameNode, Reading in) {
        String name = ((ScalarNode) nameNode).getValue();
        if (byClass.isPresent() && byClass.get().form().matches(name)) {
            try {
                return Optional.of(in.classes().find(name, byClass.get().type()));
            } catch (IllegalArgumentException e) {
                return in.problem(nameNode, e.getMessage());
            }
        }
        Optional<K> found = kinds.stream().filter(kind -> kind.getName().equals(name)).findFirst();
        if (found.isEmpty()) {
            in.problem(nameNode, elsewhere
                    .filter(other -> other.kinds().stream().anyMatch(kind -> kind.getName().equals(name)))
                    .map(other -> "'" + name + "' is " + article(other.what()) + ", not " + article(what)
                            + "; move it to '" + other.key() + "'")
                    .orElseGet(() -> Wording.unknown(what, name, kinds.stream().map(Kind::getName).toList(),
                            in.owners(name))));
        }
        return found;
    }

    private static String article(String what) {
        return ("aeiou".indexOf(what.charAt(0)) < 0 ? "a " : "an ") + what;
    }

    private Optional<Chosen<K>> bare(K kind, Node node, Reading in) {
        if (!kind.mayBeEmpty()) {
            return in.problem(node, "'" + kind.getName() + "' needs a value for at least one key: write '- "
                    + kind.getName() + ": " + kind.example() + "'");
        }
        return Optional.of(new Chosen<>(kind, new Values(in.place(node)), in.place(node)));
    }

    @Override
    public String describe() {
        return "one of " + String.join(", ", kinds.stream().map(Kind::getName).toList()) + orClass()
                + ", with its keys below it";
    }

    /** @return the alternative to a kind's name, as text to follow the names */
    public String orClass() {
        return byClass.map(other -> ", or " + other.form().describe()).orElse("");
    }

    @Override
    public Stream<MappingType> mappings() {
        return kinds.stream().flatMap(Kind::mappings);
    }

    /** @return all kinds */
    public List<K> getKinds() {
        return kinds;
    }
}
