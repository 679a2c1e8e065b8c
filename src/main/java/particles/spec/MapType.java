package particles.spec;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.snakeyaml.engine.v2.nodes.MappingNode;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.NodeTuple;

/**
 * The type of a mapping whose keys the file chooses, such as names of classes or numbers.
 *
 * @param key   the type of a key
 * @param value the type of a value
 * @param <K>   the Java class of a key
 * @param <T>   the Java class of a value
 */
public record MapType<K, T>(Type<K> key, Type<T> value) implements Type<Map<K, T>> {
    @Override
    public Optional<Map<K, T>> read(Node node, String what, Reading in) {
        if (!(node instanceof MappingNode mapping)) {
            return wrong(node, what, in);
        }
        Map<K, T> map = new LinkedHashMap<>();
        for (NodeTuple tuple : mapping.getValue()) {
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
