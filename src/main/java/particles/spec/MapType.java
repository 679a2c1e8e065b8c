package particles.spec;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.snakeyaml.engine.v2.nodes.MappingNode;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.NodeTuple;

/**
 * The type of a mapping whose keys the file chooses, such as names of classes.
 *
 * @param <T> the Java class of a value
 */
public final class MapType<T> extends Type<Map<String, T>> {
    private final Type<String> key;
    private final Type<T> value;

    private MapType(Type<String> key, Type<T> value) {
        this.key = key;
        this.value = value;
    }

    /** @return the type of a mapping with such keys and values */
    public static <T> MapType<T> of(Type<String> key, Type<T> value) {
        return new MapType<>(key, value);
    }

    @Override
    Optional<Map<String, T>> read(Node node, String what, Reading in) {
        if (!(node instanceof MappingNode)) {
            return wrong(node, what, in);
        }
        Map<String, T> map = new LinkedHashMap<>();
        for (NodeTuple tuple : ((MappingNode) node).getValue()) {
            key.read(tuple.getKeyNode(), "a key of " + what, in).ifPresent(name ->
                    value.read(tuple.getValueNode(), "'" + name + "'", in).ifPresent(found -> {
                        if (map.put(name, found) != null) {     // null where it was not there
                            in.problem(tuple.getKeyNode(), "'" + name + "' appears twice in " + what);
                        }
                    }));
        }
        return Optional.of(map);
    }

    @Override
    public String describe() {
        return "keys with values, each key " + key.describe() + ", each value " + value.describe();
    }
}
