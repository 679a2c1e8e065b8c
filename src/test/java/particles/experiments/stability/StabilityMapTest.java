package particles.experiments.stability;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.function.DoubleBinaryOperator;
import org.junit.jupiter.api.Test;
import particles.view.Look;
import particles.view.Series;

class StabilityMapTest {
    /** A half-plane, which once had a stripe more at the edge of the chart; a disc, and all but a disc. */
    @Test
    void stripesFillOnlyWhatIsStable() {
        for (DoubleBinaryOperator modulus : List.<DoubleBinaryOperator>of((x, y) -> Math.exp(x), (x, y) ->
                Math.hypot(1 + x, y), (x, y) -> 1 / Math.hypot(1 - x, y))) {
            Series stripes = new StabilityMap(modulus, 13, 260).filled(Look.OWN);
            for (int k = 1; k < stripes.x().length; k++) {
                double y = stripes.y()[k];
                double size = modulus.applyAsDouble((stripes.x()[k - 1] + stripes.x()[k]) / 2, y);
                assertTrue(!(size > 1), size + " at y = " + y);
            }
        }
    }
}
