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
        Optional<Double> number = NumberType.parse(node);
        if (number.isEmpty() || number.get() != StrictMath.rint(number.get()) || !(number.get() >= least)
                || !(number.get() <= most)) {
            return wrong(node, what, in);
        }
        return Optional.of((int) (double) number.get());
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
