package particles.spec;

import java.util.Locale;
import java.util.Optional;
import org.snakeyaml.engine.v2.nodes.Node;
import org.snakeyaml.engine.v2.nodes.ScalarNode;
import org.snakeyaml.engine.v2.nodes.Tag;

/** The type of a value that is true or false. */
public enum FlagType implements Type<Boolean> {
    FLAG;

    @Override
    public Optional<Boolean> read(Node node, String what, Reading in) {
        if (!node.getTag().equals(Tag.BOOL)) {
            return wrong(node, what, in);               // in YAML 1.2 "yes" and "no" are texts
        }
        return Optional.of(((ScalarNode) node).getValue().toLowerCase(Locale.ROOT).equals("true"));
    }

    @Override
    public Optional<Boolean> sample() {
        return Optional.of(false);
    }

    @Override
    public String describe() {
        return "true or false";
    }
}
