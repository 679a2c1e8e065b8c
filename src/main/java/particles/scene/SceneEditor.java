package particles.scene;

import deSolvers.text.Digits;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.snakeyaml.engine.v2.common.FlowStyle;
import org.snakeyaml.engine.v2.exceptions.Mark;
import org.snakeyaml.engine.v2.nodes.CollectionNode;
import org.snakeyaml.engine.v2.nodes.MappingNode;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.ScalarNode;
import org.snakeyaml.engine.v2.nodes.SequenceNode;
import particles.spec.JsonText;
import particles.spec.Reading;
import particles.spec.YamlText;
import particles.spec.messages.InvalidInputException;
import particles.spec.messages.Problems;

/**
 * Edits the text of a scene that has no mistakes: places, joins, fixes and removes particles. All other text stays as
 * it is, with its comments and line ends, in block style as in flow style; but an entry that is removed from a list in
 * flow style takes along what stands between it and the one before it. Whether the new text is a scene is for {@link
 * SceneReader} to say.
 */
public final class SceneEditor {
    /** The keys whose values are ids of particles. */
    private static final Set<String> IDS = Set.of("id", "from", "to", "particle", "about", "bead", "corners", "faces");

    private static final Pattern PLAIN = Pattern.compile("(?!(?:true|false|null)$)[A-Za-z][\\w-]*");

    private final String text;                          // with line feeds, as the parser counts
    private final String lineEnd;
    private final MappingNode root;

    /** A key and its value, or an entry of a list, which is both. */
    private record Part(Node key, Node value) {
    }

    /** The text from one place up to another becomes a new one. */
    private record Change(int from, int to, String text) {
    }

    /**
     * @param text the text
     * @throws InvalidInputException if it is not valid YAML
     */
    public SceneEditor(String text) {
        this.text = text.replaceFirst("^\ufeff", "").replaceAll("\r\n?", "\n");
        lineEnd = text.contains("\r\n") ? "\r\n" : "\n";
        Problems problems = new Problems();
        root = YamlText.compose(this.text.getBytes(StandardCharsets.UTF_8), new Reading("scene", problems))
                .filter(MappingNode.class::isInstance).map(MappingNode.class::cast)
                .orElseThrow(() -> new InvalidInputException(problems.lines()));
    }

    /**
     * @param x a coordinate (m)
     * @param y a coordinate (m)
     * @param z a coordinate (m)
     * @return the text with a particle there, whose name occurs nowhere in the scene: m1, m2 ...
     */
    public String place(double x, double y, double z) {
        int number = 1;
        while (Pattern.compile("\\bm" + number + "\\b").matcher(text).find()) {
            number++;
        }
        return with(List.of(addition("particles", "{id: m" + number + ", position: [" + Digits.exact(x) + ", "
                + Digits.exact(y) + ", " + Digits.exact(z) + "]}")));
    }

    /**
     * @param from   a particle
     * @param to     another one
     * @param muscle whether the spring is a muscle
     * @return the text with a spring between them; one that is there becomes a muscle
     */
    public String join(String from, String to, boolean muscle) {
        String ends = "{from: " + written(from) + ", to: " + written(to);
        List<Change> spring = List.of(addition("springs", ends + ", stiffness: 100, damping: 1}"));
        if (!muscle) {
            return with(spring);
        }
        boolean isThere = find(root, "springs").stream().flatMap(list -> parts(list).stream()).map(one ->
                Stream.of("from", "to").flatMap(end -> find(one.value, end).stream()).toList())
                .anyMatch(both -> both.stream().allMatch(end -> is(end, from) || is(end, to)));
        SceneEditor joined = isThere ? this : new SceneEditor(with(spring));    // both may be at the text's end
        return joined.with(List.of(joined.addition("effects",
                "muscles: {amplitude: 0.2, period: 1, springs: [" + ends + "}]}")));
    }

    /** An id, in quotes where YAML would take it for something else. */
    private static String written(String id) {
        return PLAIN.matcher(id).matches() ? id : JsonText.compact(id);
    }

    /** Adds an entry in flow style to a list at the top, which the scene may lack. */
    private Change addition(String list, String entry) {
        return find(root, list).map(node -> addition(node, entry)).orElseGet(() -> addition(root,
                list + ":" + (isFlow(root) ? " [" + entry + "]" : newLine(root) + "  - " + entry)));
    }

    /**
     * @param id a particle of the list {@code particles}
     * @return the text with this particle fixed or, if it was, free
     */
    public String toggleFixed(String id) {
        Node particle = find(root, "particles").stream().flatMap(list -> parts(list).stream()).map(Part::value)
                .filter(one -> find(one, "id").filter(name -> is(name, id)).isPresent()).findFirst().orElseThrow();
        return with(List.of(find(particle, "fixed").map(fixed -> new Change(start(fixed), end(fixed),
                text.startsWith("f", start(fixed)) ? "true" : "false"))
                .orElseGet(() -> addition(particle, "fixed: true"))));
    }

    /**
     * @param id a particle
     * @return the text without this particle and without the entries that name it: springs, muscles, faces, marks ...
     */
    public String remove(String id) {
        return with(without(root, id, false, false).orElse(List.of()));
    }

    /** Adds a part at the end of a mapping or list. */
    private Change addition(Node parent, String part) {
        List<Part> parts = parts(parent);
        Part last = parts.isEmpty() ? null : parts.get(parts.size() - 1);
        if (isFlow(parent)) {
            int at = last == null ? start(parent) + 1 : end(last.value);
            return new Change(at, at, (last == null ? "" : ", ") + part);
        }
        int at = endOfLine(end(last.value));
        return new Change(at, at, (parent == root ? "\n" : "") + newLine(parent)
                + (parent instanceof SequenceNode ? "- " : "") + part);
    }

    /** The end of a line and the indentation of a node in block style. */
    private static String newLine(Node node) {
        return "\n" + " ".repeat(node.getStartMark().orElseThrow().getColumn());
    }

    /**
     * What a node loses with a particle; empty if the whole node goes: an entry of a list that names it, and the key of
     * which nothing is left.
     *
     * @param isId    whether a text in it is the id of a particle
     * @param inEntry whether it is in an entry of a list
     */
    private Optional<List<Change>> without(Node node, String id, boolean isId, boolean inEntry) {
        if (node instanceof ScalarNode) {
            return isId && is(node, id) ? Optional.empty() : Optional.of(List.of());
        }
        List<Part> parts = parts(node);
        boolean inList = node instanceof SequenceNode;
        List<Change> changes = new ArrayList<>();
        boolean kept = parts.isEmpty();
        for (int i = 0; i < parts.size(); i++) {
            Node value = parts.get(i).value;
            Optional<List<Change>> inside = without(value, id, inList ? isId
                    : parts.get(i).key instanceof ScalarNode key && IDS.contains(key.getValue()), inEntry || inList);
            boolean needed = value instanceof ScalarNode || value instanceof SequenceNode && inEntry && !inList;
            if (inside.isEmpty() && needed) {
                return Optional.empty();
            }
            changes.addAll(inside.isPresent() ? inside.get() : List.of(removal(node, parts, i, kept)));
            kept |= inside.isPresent();
        }
        return kept ? Optional.of(changes) : Optional.empty();
    }

    /** Removes a part of a node; kept: whether one before it stays. */
    private Change removal(Node parent, List<Part> parts, int i, boolean kept) {
        int from = start(parts.get(i).key);
        int to = end(parts.get(i).value);
        if (isFlow(parent)) {
            return kept ? new Change(end(parts.get(i - 1).value), to, "")
                    : new Change(from, i + 1 < parts.size() ? start(parts.get(i + 1).key) : to, "");
        }
        if (parent instanceof SequenceNode) {           // comments may stand between the dash and its entry
            from = i == 0 ? start(parent) : text.indexOf(newLine(parent) + "-", end(parts.get(i - 1).value)) + 1;
        }
        int next = Math.min(text.length(), endOfLine(to) + 1);
        while (parent == root && next < text.length() && text.charAt(next) == '\n') {
            next++;
        }
        return new Change(text.lastIndexOf('\n', from) + 1, next, "");
    }

    private String with(List<Change> changes) {
        StringBuilder changed = new StringBuilder(text);
        changes.stream().sorted(Comparator.comparing(Change::from).reversed())
                .forEach(change -> changed.replace(change.from, change.to, change.text));
        return changed.toString().replace("\n", lineEnd);
    }

    private static List<Part> parts(Node node) {
        return node instanceof MappingNode mapping
                ? mapping.getValue().stream().map(one -> new Part(one.getKeyNode(), one.getValueNode())).toList()
                : node instanceof SequenceNode list ? list.getValue().stream().map(one -> new Part(one, one)).toList()
                : List.of();
    }

    private static Optional<Node> find(Node mapping, String key) {
        return parts(mapping).stream().filter(part -> is(part.key, key)).map(Part::value).findFirst();
    }

    private static boolean is(Node node, String text) {
        return node instanceof ScalarNode scalar && scalar.getValue().equals(text);
    }

    private static boolean isFlow(Node node) {
        return node instanceof CollectionNode<?> collection && collection.getFlowStyle() == FlowStyle.FLOW;
    }

    private int start(Node node) {
        return index(node.getStartMark());
    }

    /** Where a node ends; the parser's mark of one in block style is after the comments that follow. */
    private int end(Node node) {
        List<Part> parts = parts(node);
        int end = isFlow(node) || parts.isEmpty() ? index(node.getEndMark())
                : end(parts.get(parts.size() - 1).value);
        return text.substring(0, end).stripTrailing().length();
    }

    private int endOfLine(int at) {
        int end = text.indexOf('\n', at);
        return end < 0 ? text.length() : end;
    }

    /** The parser counts characters, of which some are two in Java. */
    private int index(Optional<Mark> mark) {
        return text.offsetByCodePoints(0, mark.orElseThrow().getIndex());
    }
}
