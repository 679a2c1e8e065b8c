package particles.spec;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.SequenceNode;
import particles.law.Vector3;

/**
 * The type of a vector, written [x, y, z].
 *
 * @param component   the type of x, y and z
 * @param zeroAllowed whether it may be [0, 0, 0]
 */
public record VectorType(NumberType component, boolean zeroAllowed) implements Type<Vector3> {
    /** @return the type of any vector; the unit is that of its components */
    public static VectorType of(String unit) {
        return new VectorType(NumberType.any(unit), true);
    }

    /** @return the type of vectors other than [0, 0, 0]; the unit is empty if only the direction matters */
    public static VectorType notZero(String unit) {
        return new VectorType(NumberType.any(unit), false);
    }

    /** @return the type of three numbers over 0; the unit is that of each */
    public static VectorType positive(String unit) {
        return new VectorType(NumberType.positive(unit), true);
    }

    @Override
    public String describe() {
        return "three " + component.range().replace("a number", "numbers") + " [x, y, z]"
                + (zeroAllowed ? "" : ", not all 0") + component.inUnit();
    }

    @Override
    public Optional<Vector3> read(Node node, String what, Reading in) {
        if (!(node instanceof SequenceNode sequence)) {
            return wrong(node, what, in);
        }
        List<Node> nodes = sequence.getValue();
        if (nodes.size() != 3) {
            return in.problem(node, what + " has " + nodes.size() + (nodes.size() == 1 ? " entry" : " entries")
                    + "; it has to be " + describe());
        }
        double[] values = IntStream.range(0, 3).mapToObj(i ->
                component.read(nodes.get(i), "xyz".charAt(i) + " of " + what, in))
                .flatMap(Optional::stream).mapToDouble(Double::doubleValue).toArray();
        if (values.length < 3) {
            return Optional.empty();
        }
        Vector3 vector = Vector3.at(values, 0);
        return zeroAllowed || !vector.isZero() ? Optional.of(vector) : wrong(node, what, in);
    }

    @Override
    public Optional<Vector3> sample() {
        return Optional.of(new Vector3(1, 0.5, 0.8));
    }

    @Override
    public Object toJson(Vector3 value) {
        return List.of(value.x(), value.y(), value.z());
    }
}
