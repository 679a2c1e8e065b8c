package particles.spec;

import java.util.Optional;
import org.snakeyaml.engine.v2.nodes.Node;

/** The type of a whole number in a range; 20.0 and 2e1 count as 20. */
public final class WholeNumberType extends Type<Integer> {
    final int least;
    final int most;

    /**
     * @param least the smallest number allowed
     * @param most  the largest number allowed
     */
    public WholeNumberType(int least, int most) {
        this.least = least;
        this.most = most;
    }

    @Override
    Optional<Integer> read(Node node, String what, Reading in) {
        Optional<Double> number = NumberType.parse(node);
        if (number.isEmpty() || number.get() != StrictMath.rint(number.get()) || !(number.get() >= least)
                || !(number.get() <= most)) {
            return wrong(node, what, in);
        }
        return Optional.of((int) (double) number.get());
    }

    @Override
    Optional<Integer> sample() {
        return Optional.of(Math.max(least, Math.min(2, most)));
    }

    @Override
    public String describe() {
        return "a whole number from " + least + " to " + most;
    }
}
