package particles.spec;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.snakeyaml.engine.v2.common.FlowStyle;
import org.snakeyaml.engine.v2.common.ScalarStyle;
import org.snakeyaml.engine.v2.exceptions.Mark;
import org.snakeyaml.engine.v2.nodes.MappingNode;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.NodeTuple;
import org.snakeyaml.engine.v2.nodes.ScalarNode;
import org.snakeyaml.engine.v2.nodes.SequenceNode;
import org.snakeyaml.engine.v2.nodes.Tag;
import org.snakeyaml.engine.v2.schema.CoreSchema;
import particles.spec.messages.Place;
import particles.spec.messages.Problems;
import particles.spec.messages.Wording;

/**
 * A value for a key of a file, given outside it. It is put into the file's tree before that is read, so a wrong one is
 * reported like a wrong value in the file, with the option as its place.
 *
 * <p>The key is the way to it from the top of the file: {@code deltaT}, {@code springs[0].damping} for the first
 * spring, {@code particles.block.mass} for the particle of this id, {@code effects.gravity.acceleration} for the effect
 * of this name, which is added if the file has none.
 */
public final class Setting {
    private static final Pattern KEY = Pattern.compile("[\\w-]+(?:\\.[\\w-]+|\\[\\d{1,6}])*");
    private static final String ID = "id";
    /** The type of what is below a key that does not exist: nothing there is known, and reading reports the key. */
    private static final MappingType UNKNOWN = MappingType.of("");

    private final String key;
    private final String option;
    private final Node value;

    private Setting(String key, String option, Node value) {
        this.key = key;
        this.option = option;
        this.value = value;
    }

    /**
     * @param key      the key
     * @param value    its value as in a file, in one line
     * @param option   the option that gives it, such as {@code -Pset}; with the key, the place of all problems
     * @param problems receives the problems
     * @return the setting, or empty if a problem was reported
     */
    public static Optional<Setting> of(String key, String value, String option, Problems problems) {
        if (!KEY.matcher(key).matches()) {
            return problems.add(Place.of(option), Wording.quote(key) + " is not a key such as deltaT,"
                    + " springs[0].damping or effects.gravity.acceleration");
        }
        String place = option + " " + key;
        if (value.isBlank()) {
            return problems.add(Place.of(place), "a value is missing: " + key + " = VALUE");
        }
        return YamlText.compose(value.getBytes(StandardCharsets.UTF_8), new Reading(place, problems))
                .map(node -> new Setting(key, place, at(node, mark(place))));
    }

    /**
     * Reads an option that stands for a key at the top of a file; its value is checked as in a file.
     *
     * @param key      the key
     * @param text     the value as it was typed
     * @param option   the option as it was typed, such as {@code -PdeltaT}; the place of all problems
     * @param problems receives the problems
     * @return the setting, or empty if a problem was reported
     */
    public static Optional<Setting> of(Key<?> key, String text, String option, Problems problems) {
        Node node = new ScalarNode(new CoreSchema().getScalarResolver().resolve(text, true), true, text,
                ScalarStyle.PLAIN, mark(option), mark(option));
        return key.type().read(node, "the value", new Reading(option, problems)).map(value ->
                new Setting(key.name(), option, node));
    }

    /**
     * Reads settings such as {@code springs[0].damping = 20, effects.gravity.acceleration = [0, -1.62, 0]}.
     *
     * @param text     the settings
     * @param option   the option that gives them
     * @param problems receives the problems
     * @return those without a problem
     */
    public static List<Setting> list(String text, String option, Problems problems) {
        List<Setting> settings = new ArrayList<>();
        for (String one : split(text, ',')) {
            int equals = one.indexOf('=');
            if (equals < 0) {
                problems.add(Place.of(option), Wording.quote(one.strip()) + " has to be KEY = VALUE");
            } else {
                of(one.substring(0, equals).strip(), one.substring(equals + 1).strip(), option, problems)
                        .ifPresent(settings::add);
            }
        }
        return settings;
    }

    /** @return the parts between separators that stand outside brackets and quotes */
    public static List<String> split(String text, char separator) {
        List<String> parts = new ArrayList<>();
        int depth = 0;
        int begin = 0;
        char quote = 0;
        for (int i = 0; i < text.length(); i++) {
            char c = text.charAt(i);
            if (quote != 0 || c == '"' || c == '\'') {
                quote = quote == 0 ? c : c == quote ? 0 : quote;
            } else if (c == separator && depth == 0) {
                parts.add(text.substring(begin, i));
                begin = i + 1;
            } else {
                depth += c == '[' || c == '{' ? 1 : c == ']' || c == '}' ? -1 : 0;
            }
        }
        parts.add(text.substring(begin));
        return parts;
    }

    /** @return the place of its value in messages */
    public Place getPlace() {
        return Place.of(option);
    }

    /** @return the tree of a file of this type with this value in it; unchanged if a problem was reported */
    Node applyTo(MappingType type, Node root, Reading in) {
        int before = in.problems().count();
        Node changed = put(type, root, List.of(key.replace("[", ".[").split("[.]")), in);
        return in.problems().count() > before ? root : changed;
    }

    /** The tree of a value of this type with this value at the end of the path; old is empty where there is none. */
    private Node put(Type<?> type, Node old, List<String> path, Reading in) {
        if (path.isEmpty()) {
            return value;
        }
        if (type instanceof KindType<?> kinds) {
            return inKind(kinds, old, path, in);
        }
        String step = path.get(0);
        List<String> rest = path.subList(1, path.size());
        if (step.startsWith("[") || type instanceof ListType) {
            return inList(type instanceof ListType<?> list ? list.element() : UNKNOWN, old, step, rest, in);
        }
        return type instanceof MappingType mapping ? entry(mapping, old, step, rest, in)
                : problem(in, "it is " + type.describe() + ", and has no " + Wording.quote(step));
    }

    /** A mapping with a key changed or added. */
    private Node entry(MappingType type, Node old, String name, List<String> rest, Reading in) {
        List<NodeTuple> entries = new ArrayList<>();
        if (old instanceof MappingNode mapping) {
            entries.addAll(mapping.getValue());
        } else {
            type.getShortForm().ifPresent(brief -> entries.add(new NodeTuple(word(brief.name()), old)));
        }
        int k = IntStream.range(0, entries.size()).filter(i -> is(entries.get(i).getKeyNode(), name)).findFirst()
                .orElse(entries.size());
        if (k == entries.size()) {
            entries.add(new NodeTuple(word(name), mapping(List.of(), value.getStartMark())));
        }
        Type<?> child = type.getKeys().stream().filter(known -> known.name().equals(name))
                .<Type<?>>map(Key::type).findFirst().orElse(UNKNOWN);
        entries.set(k, new NodeTuple(word(name), put(child, entries.get(k).getValueNode(), rest, in)));
        return mapping(entries, old.getStartMark());
    }

    /** A list with the entry changed that has this number or id, or is of the kind of this name. */
    private Node inList(Type<?> type, Node old, String step, List<String> rest, Reading in) {
        List<Node> items = new ArrayList<>(old instanceof SequenceNode list ? list.getValue() : List.of());
        boolean numbered = step.startsWith("[");
        List<Integer> found = IntStream.range(0, items.size()).filter(i -> numbered ? step.equals("[" + i + "]")
                : names(items.get(i)).anyMatch(step::equals)).boxed().toList();
        if (found.size() > 1) {
            return problem(in, found.size() + " entries are called " + Wording.quote(step)
                    + "; give the number of one, from [" + found.get(0) + "]");
        }
        if (found.isEmpty() && (numbered || !(type instanceof KindType))) {
            List<String> known = items.stream().flatMap(Setting::names).toList();
            return problem(in, numbered && items.isEmpty() ? "there is no list for " + step
                    : numbered ? step + " does not exist; the last one is [" + (items.size() - 1) + "]"
                    : known.isEmpty() ? "the entries of this list have no names; give a number, such as [0]"
                    : Wording.unknown("entry", step, known, List.of()));
        }
        if (found.isEmpty()) {
            items.add(word(step));
        }
        int k = found.isEmpty() ? items.size() - 1 : found.get(0);
        items.set(k, !numbered && type instanceof KindType<?> kinds ? inKind(kinds, items.get(k), rest, in)
                : put(type, items.get(k), rest, in));
        return sequence(items, old.getStartMark());
    }

    /** An entry that names a kind; its own name may be a step of the path. */
    private Node inKind(KindType<?> type, Node item, List<String> path, Reading in) {
        NodeTuple entry = item instanceof MappingNode mapping && !mapping.getValue().isEmpty()
                ? mapping.getValue().get(0) : new NodeTuple(item, mapping(List.of(), item.getStartMark()));
        Node name = entry.getKeyNode();
        List<String> rest = !path.isEmpty() && is(name, path.get(0)) ? path.subList(1, path.size()) : path;
        Type<?> kind = type.kinds().stream().filter(known -> is(name, known.getName())).<Type<?>>map(known -> known)
                .findFirst().orElse(UNKNOWN);
        return mapping(List.of(new NodeTuple(name, put(kind, entry.getValueNode(), rest, in))), item.getStartMark());
    }

    /** The names by which an entry of a list can be called: its kind, and its id. */
    private static Stream<String> names(Node item) {
        if (item instanceof ScalarNode scalar) {
            return Stream.of(scalar.getValue());
        }
        if (!(item instanceof MappingNode mapping)) {
            return Stream.empty();
        }
        boolean kind = mapping.getValue().size() == 1 && !is(mapping.getValue().get(0).getKeyNode(), ID);
        return kind ? Stream.concat(Stream.of(mapping.getValue().get(0).getKeyNode()).flatMap(Setting::names),
                ids(mapping.getValue().get(0).getValueNode())) : ids(mapping);
    }

    private static Stream<String> ids(Node node) {
        return node instanceof MappingNode mapping ? mapping.getValue().stream().filter(entry ->
                is(entry.getKeyNode(), ID)).map(NodeTuple::getValueNode).filter(ScalarNode.class::isInstance)
                .map(id -> ((ScalarNode) id).getValue()) : Stream.empty();
    }

    private static boolean is(Node node, String text) {
        return node instanceof ScalarNode scalar && scalar.getValue().equals(text);
    }

    private Node problem(Reading in, String message) {
        in.problems().add(getPlace(), message);
        return value;
    }

    private Node word(String text) {
        return new ScalarNode(Tag.STR, true, text, ScalarStyle.PLAIN, value.getStartMark(), value.getEndMark());
    }

    private static Node mapping(List<NodeTuple> entries, Optional<Mark> mark) {
        return new MappingNode(Tag.MAP, true, entries, FlowStyle.FLOW, mark, mark);
    }

    private static Node sequence(List<Node> items, Optional<Mark> mark) {
        return new SequenceNode(Tag.SEQ, true, items, FlowStyle.FLOW, mark, mark);
    }

    /** The place of a whole option. */
    private static Optional<Mark> mark(String option) {
        return Optional.of(new Mark(option, 0, -1, -1, new int[0], 0));
    }

    /** A tree of which every node is at this place. */
    private static Node at(Node node, Optional<Mark> mark) {
        if (node instanceof MappingNode mapping) {
            return mapping(mapping.getValue().stream().map(entry -> new NodeTuple(at(entry.getKeyNode(), mark),
                    at(entry.getValueNode(), mark))).toList(), mark);
        }
        if (node instanceof SequenceNode list) {
            return sequence(list.getValue().stream().map(item -> at(item, mark)).toList(), mark);
        }
        ScalarNode scalar = (ScalarNode) node;
        return new ScalarNode(scalar.getTag(), true, scalar.getValue(), scalar.getScalarStyle(), mark, mark);
    }
}
