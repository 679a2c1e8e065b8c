package particles.spec;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.ScalarNode;
import particles.spec.messages.Place;
import particles.spec.messages.Problems;
import particles.spec.messages.Wording;

/**
 * The context of reading one source: its name, its problems and the classes it may name.
 *
 * @param source   its name in messages
 * @param problems receives the problems
 * @param classes  finds students' classes by name
 * @param numbers  receives the numbers that are right
 * @param format   the format of the whole source, once it is known; for hints about misplaced keys
 */
public record Reading(String source, Problems problems, ClassNames classes, List<NumberInText> numbers,
                      Optional<MappingType> format) {

    /**
     * A number that a text gives.
     *
     * @param what  its name in messages, such as {@code 'mass'}
     * @param value its value
     * @param place where it is
     * @param least the smallest value allowed
     * @param most  the largest value allowed
     * @param unit  its unit; empty for pure numbers
     */
    public record NumberInText(String what, double value, Place place, double least, double most, String unit) {
    }

    private static final Pattern CURLY_QUOTED = Pattern.compile("^[" + Wording.CURLY_QUOTES + "]");

    /** A source whose format is not known yet. */
    public Reading(String source, Problems problems, ClassNames classes) {
        this(source, problems, classes, new ArrayList<>(), Optional.empty());
    }

    /** A source that names no classes. */
    public Reading(String source, Problems problems) {
        this(source, problems, ClassNames.none());
    }

    /** @return the same, once the format is known */
    Reading inFormat(MappingType type) {
        return new Reading(source, problems, classes, numbers, Optional.of(type));
    }

    /** @return the names of all mappings of the format that have this key */
    List<String> owners(String key) {
        return format.stream().flatMap(MappingType::mappings).filter(mapping -> mapping.getKeys().stream()
                .anyMatch(known -> known.name().equals(key))).map(MappingType::getLabel).distinct().toList();
    }

    /** As {@link Problems#add}, for the source as a whole. */
    <T> Optional<T> problem(String message) {
        return problems.add(Place.of(source), message);
    }

    /** As {@link Problems#add}, at a node. */
    <T> Optional<T> problem(Node node, String message) {
        boolean curly = node instanceof ScalarNode scalar && CURLY_QUOTED.matcher(scalar.getValue()).find();
        return problems.add(place(node), message
                + (curly ? "; curly quotes are part of the text: type ordinary ones, or none" : ""));
    }

    /** A value from an option has no position; its place is the whole option. */
    Place place(Node node) {
        return Place.of(source, node.getStartMark());
    }
}
