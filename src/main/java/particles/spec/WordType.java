package particles.spec;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.ScalarNode;

/** The type of any single value, a number or a text, kept as written. */
public final class WordType extends Type<String> {
    private final String description;

    private WordType(String description) {
        this.description = description;
    }

    /**
     * @param description the value's meaning and allowed form
     * @return a type that accepts any single value unchecked
     */
    public static WordType of(String description) {
        return new WordType(description);
    }

    @Override
    Optional<String> read(Node node, String what, Reading in) {
        return node instanceof ScalarNode scalar ? Optional.of(scalar.getValue()) : wrong(node, what, in);
    }

    @Override
    public String describe() {
        return description;
    }

    @Override
    Map<String, Object> schema() {
        return Map.of("type", List.of("string", "number", "boolean"));
    }
}
