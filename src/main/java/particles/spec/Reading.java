package particles.spec;

import org.snakeyaml.engine.v2.nodes.Node;
import particles.spec.messages.Place;
import particles.spec.messages.Problems;

/**
 * The context of reading one source: its name, its problems and the classes it may name.
 *
 * @param source   its name in messages
 * @param problems where problems go
 * @param classes  finds what is named by a class
 */
public record Reading(String source, Problems problems, ClassNames classes) {

    /** Without classes. */
    public Reading(String source, Problems problems) {
        this(source, problems, ClassNames.none());
    }

    void problem(Node node, String message) {
        problems.add(place(node), message);
    }

    /** A value from an option has no position; its place is the whole option. */
    Place place(Node node) {
        return Place.of(source, node);
    }
}
