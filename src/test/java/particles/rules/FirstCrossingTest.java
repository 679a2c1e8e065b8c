package particles.rules;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import particles.SimulationException;
import particles.scene.ShortRun;

/** Roots of polynomials that are known, and polynomials that have none to be found. */
class FirstCrossingTest {

    /** (u - 1/4)(u - 3/4) has the B&eacute;zier coefficients 3/16, -5/16, 3/16. */
    @Test
    void theFirstOfTwoRootsIsFound() {
        assertEquals(0.25, new FirstCrossing().of(new double[] {0.1875, -0.3125, 0.1875}, 3), 0x1p-44);
        assertTrue(Double.isNaN(new FirstCrossing().of(new double[] {0.1875, 0.3125, 0.1875}, 3)));
    }

    /** Halving such a polynomial gives two like it, 2^45 in the end: without a check the search takes months. */
    @ParameterizedTest
    @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY})
    void whatOverflowsIsNotSearched(double coefficient) {
        assertTrue(Double.isNaN(new FirstCrossing().of(new double[] {1, coefficient, -coefficient, 1}, 4)));
    }

    /** Drag of 1e35 1/s in a wind of 1e30 m/s: rk4 throws the leaf so far that its path overflows; the run says so. */
    @ParameterizedTest
    @ValueSource(strings = {"exact", "clamp"})
    void aRunWhosePathsOverflowEndsAsABlowUp(String impact) {
        ShortRun run = new ShortRun("rk4 " + impact + " 0.01 1", """
                particles: [{id: leaf, position: [2, 0, 0], mass: 1e-5}]
                effects: [drag: {coefficient: 1e30}, wind: {mean: [-1e30, 0, 0]}]
                rules: [sphere: {centre: [0, 0, 0], radius: 1, restitution: 0.5}]
                """);
        SimulationException e = assertThrows(SimulationException.class, run::run);
        assertEquals(SimulationException.End.ENERGY_LIMIT, e.getEnd());
        assertEquals(0.01, e.getTime(), 1e-12);
    }
}
