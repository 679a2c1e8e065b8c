package particles.experiments;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import particles.ChartData;
import particles.experiments.StiffGallery.Sweep;

class StiffGalleryTest {
    private static Sweep sweep(String solver, int decades) {
        return StiffGallery.sweep(SolverChoice.of(solver), decades);
    }

    /** The limits of h omega are the catalogue's; 10 s of omega = sqrt(1 + 4e6) take 10 omega / limit steps. */
    @ParameterizedTest
    @CsvSource({"rk4, 4", "verlet, 1", "symplectic-euler, 1"})
    void explicitCostGrowsAsTheRootOfTheStiffness(String solver, int evaluations) {
        Sweep sweep = sweep(solver, 6);
        assertFalse(sweep.neverStable());
        assertEquals(0.5, sweep.stableExponent(), 0.05);
        assertEquals(0.5, sweep.preciseExponent(), 0.05);
        double steps = 10 * Math.sqrt(1 + 4e6) / SolverChoice.of(solver).info().orElseThrow().imaginaryLimit();
        assertEquals(1, sweep.costs().get(6).toBeStable() / (steps * evaluations), 0.03);
    }

    @ParameterizedTest
    @ValueSource(strings = {"backward-euler", "implicit-midpoint"})
    void implicitCostIsFlat(String solver) {
        Sweep sweep = sweep(solver, 6);
        assertEquals(0, sweep.stableExponent(), 0.1);
        assertEquals(0, sweep.preciseExponent(), 0.1);
    }

    @Test
    void backwardEulerPaysWithDampingAndImplicitMidpointDoesNot() {
        assertTrue(sweep("backward-euler", 4).costs().get(4).vibrationLeft() < 1e-9);
        assertEquals(1, sweep("implicit-midpoint", 4).costs().get(4).vibrationLeft(), 1e-3);
    }

    @ParameterizedTest
    @ValueSource(strings = {"euler", "midpoint", "adams"})
    void undampedVibrationGrowsAtAnyStep(String solver) {
        Sweep sweep = sweep(solver, 4);
        assertTrue(sweep.neverStable());
        assertTrue(sweep.costs().stream().allMatch(cost -> Double.isNaN(cost.toBeStable())));
        ChartData stable = StiffCharts.charts(List.of(sweep)).get(1);
        assertEquals(ChartData.Mark.FAILURES, stable.series().get(1).mark());
        assertEquals(5, stable.series().get(1).x().length);
    }
}
