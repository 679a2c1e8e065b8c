package particles.spec;

import deSolvers.text.DidYouMean;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.snakeyaml.engine.v2.nodes.MappingNode;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.NodeTuple;
import org.snakeyaml.engine.v2.nodes.ScalarNode;
import org.snakeyaml.engine.v2.nodes.Tag;
import particles.spec.messages.Place;
import particles.spec.messages.Wording;

/** The type of a mapping with known keys. */
public class MappingType implements Type<Values> {
    private final String label;
    private final String sentence;
    private final List<Key<?>> keys;
    final List<Key<?>> exactlyOneOf;
    private final Optional<Key<?>> shortFor;

    /** With a label for messages, a description, its keys, those that exclude each other, and its short form. */
    MappingType(String label, String sentence, List<Key<?>> keys, List<Key<?>> exactlyOneOf,
            Optional<Key<?>> shortFor) {
        this.label = label;
        this.sentence = sentence;
        this.keys = keys;
        this.exactlyOneOf = exactlyOneOf;
        this.shortFor = shortFor;
    }

    /**
     * @param label the name of the mapping in messages
     * @param keys  its keys, in the order in which they are explained
     * @return the type
     */
    public static MappingType of(String label, Key<?>... keys) {
        return new MappingType(label, "", List.of(keys), List.of(), Optional.empty());
    }

    /** @return this type with a short form: the value of this key alone, where no other key is needed */
    public MappingType shortFor(Key<?> key) {
        return new MappingType(label, sentence, keys, exactlyOneOf, Optional.of(key));
    }

    /** @return a key for a list of such mappings, which is empty if the key is absent */
    public Key<List<Values>> list(String name, String listSentence) {
        return ListType.of(label, this).withDefault(name, List.of(), listSentence);
    }

    /**
     * Reads a whole file.
     *
     * @param bytes its contents
     * @param in    its name, and the list that receives problems
     * @return all values without mistakes; empty if the file is not valid YAML
     */
    public Optional<Values> read(byte[] bytes, Reading in) {
        return read(bytes, List.of(), in);
    }

    /** The same, with these values in place of the file's own. */
    public Optional<Values> read(byte[] bytes, List<Setting> settings, Reading in) {
        return YamlText.compose(bytes, in).flatMap(root -> {
            Node changed = root;
            for (Setting setting : settings) {
                changed = setting.applyTo(this, changed, in);
            }
            return read(changed, label, in.inFormat(this));
        });
    }

    /** {@inheritDoc} Always returns the values that are right; {@link Values#isSound()} says whether all are. */
    @Override
    public Optional<Values> read(Node node, String what, Reading in) {
        Values values = new Values(in.place(node));
        int before = in.problems().count();
        if (node instanceof MappingNode mapping) {
            readEntries(mapping, values, in);
        } else if (shortFor.isEmpty() || node.getTag().equals(Tag.NULL)) {
            wrong(node, what, in);
        } else {
            readValue(shortFor.get(), node, what, values, in);
        }
        values.setSound(in.problems().count() == before);
        return Optional.of(values);
    }

    private void readEntries(MappingNode node, Values values, Reading in) {
        Set<String> misspelt = new HashSet<>();
        for (NodeTuple tuple : node.getValue()) {
            if (!in.problems().isFull()) {
                readEntry(tuple.getKeyNode(), tuple.getValueNode(), misspelt, values, in);
            }
        }
        for (Key<?> key : keys) {
            if (key.required() && !values.isGiven(key) && !misspelt.contains(key.name())) {
                in.problem(node, label + " needs '" + key.name() + "': " + key.type().describe());
            }
        }
        if (!exactlyOneOf.isEmpty() && exactlyOneOf.stream().filter(values::isGiven).count() != 1) {
            in.problem(node, label + " needs exactly one of " + names(exactlyOneOf));
        }
    }

    private void readEntry(Node keyNode, Node valueNode, Set<String> misspelt, Values values, Reading in) {
        if (!(keyNode instanceof ScalarNode scalar)) {
            in.problem(keyNode, "a key of " + label + " is " + Wording.describe(keyNode) + "; it has to be one of "
                    + names(keys));
            return;
        }
        String text = scalar.getValue();
        Optional<Key<?>> key = keys.stream().filter(k -> k.name().equals(text)).findFirst();
        if (key.isEmpty()) {
            List<String> known = keys.stream().map(Key::name).toList();
            DidYouMean.nearest(text, known).ifPresent(misspelt::add);
            in.problem(keyNode, NumberType.parse(keyNode).isPresent() && known.stream().allMatch(MappingType::isWord)
                    ? "a number where a key of " + label
                    + " should be; numbers have a decimal point, not a comma, and several of them stand in [ ]"
                    : Wording.unknown("key", text, known, in.owners(text), "known in " + label));
        } else if (values.isGiven(key.get())) {
            in.problem(keyNode, "'" + text + "' appears twice in " + label);
        } else if (valueNode.getTag().equals(Tag.NULL)) {
            values.put(key.get(), Optional.empty(), in.place(keyNode), false);
            in.problem(keyNode, "'" + text + "' has no value; it has to be " + key.get().type().describe());
        } else {
            readValue(key.get(), valueNode, "'" + text + "'", values, in);
        }
    }

    private static boolean isWord(String key) {
        return Character.isLetter(key.charAt(0));
    }

    private static <T> void readValue(Key<T> key, Node node, String what, Values values, Reading in) {
        int before = in.problems().count();
        Optional<T> value = key.type().read(node, what, in);
        values.put(key, value, in.place(node), in.problems().count() == before);
    }

    private static String names(List<Key<?>> keys) {
        return String.join(", ", keys.stream().map(key -> "'" + key.name() + "'").toList());
    }

    /**
     * @return values for trying out a kind: the defaults, and samples for required keys
     * @throws IllegalArgumentException if a required key has a type without a sample
     */
    public Values samples() {
        Values values = new Values(Place.of("a sample"));
        keys.stream().filter(Key::required).forEach(key -> values.put(key, key.type().sample().or(() -> {
            throw new IllegalArgumentException("no value for the key '" + key.name()
                    + "' can be made up; give it a default");
        }), values.getPlace(), true));
        return values;
    }

    @Override
    public String describe() {
        return (shortFor.isPresent() ? shortFor.get().type().describe() + "; or " : "") + "keys with values, such as "
                + example() + (keys.size() == necessary().size() ? "" : "; keys: "
                + String.join(", ", keys.stream().map(Key::name).toList()));
    }

    /** @return an example of a short mapping, such as {@code {coefficient: ...}} */
    String example() {
        return necessary().stream().map(key -> key.name() + ": ...").collect(Collectors.joining(", ", "{", "}"));
    }

    /** The required keys; the first key if none is required. */
    private List<Key<?>> necessary() {
        List<Key<?>> found = Stream.concat(keys.stream().filter(Key::required), exactlyOneOf.stream().limit(1))
                .toList();
        return found.isEmpty() ? keys.subList(0, Math.min(1, keys.size())) : found;
    }

    @Override
    public Stream<MappingType> mappings() {
        return Stream.concat(Stream.of(this), keys.stream().flatMap(key -> key.type().mappings()));
    }

    /** @return the name of the mapping in messages */
    public String getLabel() {
        return label;
    }

    /** @return a description in one sentence; empty if the key that has the mapping is enough */
    public String getSentence() {
        return sentence;
    }

    /** @return the keys, in the order in which they are explained */
    public List<Key<?>> getKeys() {
        return keys;
    }

    /** @return the key whose value may stand alone, if there is one */
    public Optional<Key<?>> getShortForm() {
        return shortFor;
    }

    /** @return whether no key is required */
    boolean mayBeEmpty() {
        return exactlyOneOf.isEmpty() && keys.stream().noneMatch(Key::required);
    }
}
