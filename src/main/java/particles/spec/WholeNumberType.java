package particles.spec;

import java.util.Optional;
import org.snakeyaml.engine.v2.nodes.Node;

/**
 * The type of a whole number in a range; 20.0 and 2e1 count as 20.
 *
 * @param least the smallest number allowed
 * @param most  the largest number allowed
 */
public record WholeNumberType(int least, int most) implements Type<Integer> {
    @Override
    public Optional<Integer> read(Node node, String what, Reading in) {
        return NumberType.parse(node).filter(number -> number == StrictMath.rint(number) && number >= least
                && number <= most).map(Double::intValue).or(() -> wrong(node, what, in));
    }

    @Override
    public Optional<Integer> sample() {
        return Optional.of(Math.max(least, Math.min(2, most)));
    }

    @Override
    public String describe() {
        return "a whole number from " + least + " to " + most;
    }
}
