package particles.experiments.stability;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.geom.Path2D;
import java.util.List;
import java.util.function.DoubleBinaryOperator;
import org.junit.jupiter.api.Test;
import particles.view.Look;
import particles.view.Series;

class StabilityMapTest {
    /** A half-plane, a disc, and all but a disc: at each point, but for those at the outline. */
    @Test
    void areasAreWhereAStepDoesNotGrow() {
        for (DoubleBinaryOperator modulus : List.<DoubleBinaryOperator>of((x, y) -> Math.exp(x), (x, y) ->
                Math.hypot(1 + x, y), (x, y) -> 1 / Math.hypot(1 - x, y))) {
            Series lines = new StabilityMap(modulus, 3, 60).filled(Look.OWN);
            Path2D area = new Path2D.Double(Path2D.WIND_EVEN_ODD);
            boolean begins = true;
            for (int k = 0; k < lines.x().length; k++) {
                if (Double.isNaN(lines.x()[k])) {
                    area.closePath();
                } else if (begins) {
                    area.moveTo(lines.x()[k], lines.y()[k]);
                } else {
                    area.lineTo(lines.x()[k], lines.y()[k]);
                }
                begins = Double.isNaN(lines.x()[k]);
            }
            for (double x = -3; x <= 3; x += 0.03) {
                for (double y = -3; y <= 3; y += 0.03) {
                    double size = modulus.applyAsDouble(x, y);
                    assertTrue(Math.abs(size - 1) < 0.01 || area.contains(x, y) == size < 1, size + " at " + x + ", "
                            + y);
                }
            }
        }
    }
}
