package particles.experiments.work;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.problems.StiffSpringPair;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import particles.experiments.runs.SolverChoice;
import particles.experiments.work.StiffGallery.Cost;
import particles.view.Chart;
import particles.view.Series;

class StiffGalleryTest {
    private static List<Cost> sweep(String solver, int decades) {
        return StiffGallery.sweep(SolverChoice.of(solver), decades);
    }

    /** The limits of h omega are the catalogue's; 10 s of omega = sqrt(1 + 4e8) take 10 omega / limit steps. */
    @Tag("slow")
    @ParameterizedTest
    @CsvSource({"rk4, 4", "verlet, 1"})
    void explicitCostGrowsAsTheRootOfTheStiffnessOverEightDecades(String solver, int evaluations) {
        List<Cost> sweep = sweep(solver, 8);
        assertEquals(9, sweep.size());
        assertEquals(0.5, StiffGallery.exponent(sweep, Cost::toBeStable), 0.005);       // measured 0.5001 and 0.4991,
        // before they are rounded
        assertEquals(0.5, StiffGallery.exponent(sweep, Cost::toOnePercent), 0.005);
        double steps = 10 * Math.sqrt(1 + 4e8) / SolverChoice.of(solver).info().orElseThrow().imaginaryLimit();
        assertEquals(1, sweep.get(8).toBeStable() / (steps * evaluations), 0.03);
    }

    /**
     * Also where a run has few steps, the step of a run that counts as stable is within the limit, 1 % and a step
     * from it. What is left of rk4's vibration there is less than at the start; a symplectic solver's energy
     * oscillates by up to (1 + h omega / 2) / (1 - h omega / 2), which is 400 for symplectic Euler 1 % from its limit.
     */
    @ParameterizedTest
    @CsvSource(textBlock = """
            rk4, 4, 1
            symplectic-euler, 1, 1000
            verlet, 1, 1000
            yoshida4, 3, 1000
            """)
    void whatCountsAsStableIsWithinTheLimit(String solver, int evaluations, double most) {
        double limit = SolverChoice.of(solver).info().orElseThrow().imaginaryLimit();
        for (Cost cost : sweep(solver, 5)) {
            double fewest = 10 * new StiffSpringPair(cost.stiffness()).omega() / limit;
            double steps = Math.floor(cost.toBeStable() / evaluations);
            assertTrue(steps > fewest * (1 - 5e-4) && steps < fewest / 0.99 + 2,
                    cost + ": " + fewest + " steps at the limit");
            assertTrue(cost.toOnePercent() > evaluations * fewest * (1 - 5e-4), cost + ": 1 % needs stability");
            assertTrue(cost.vibrationLeft() <= most, cost.toString());
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"backward-euler", "implicit-midpoint", "radau"})
    void implicitCostIsFlatOverEightDecades(String solver) {
        List<Cost> sweep = sweep(solver, 8);
        if (!sweep.get(0).solver().adaptive()) {
            assertEquals(0, StiffGallery.exponent(sweep, Cost::toBeStable), 0.05);      // measured 0.001 and 0.012
        }
        assertEquals(0, StiffGallery.exponent(sweep, Cost::toOnePercent), 0.05);     // measured 1e-6, 0.007 and 0.021
    }

    /** At the cheapest step that is precise, far beyond the stiff spring's period. */
    @Test
    void backwardEulerAndRadauPayWithDampingAndImplicitMidpointDoesNot() {
        assertTrue(sweep("backward-euler", 4).get(4).vibrationLeft() < 1e-20, "measured 2e-21 or less");
        assertTrue(sweep("radau", 4).get(4).vibrationLeft() < 1e-20);
        assertEquals(1, sweep("implicit-midpoint", 4).get(4).vibrationLeft(), 1e-6);
        assertEquals(1, sweep("verlet", 4).get(4).vibrationLeft(), 0.1);
    }

    /**
     * What grows as (h omega)^q / c a step stays small over a time as long as h^(q-1) omega^q does: steps as k^(q / (2q
     * - 2)).
     */
    @Tag("slow")
    @ParameterizedTest
    @CsvSource({"midpoint, 4, 0.01", "adams, 5, 0.02"})
    void theRaceOfThoseThatGrowIsDearerThanStability(String solver, int q, double bound) {
        // measured 0.667 and 0.618
        assertEquals(q / (2.0 * q - 2), StiffGallery.exponent(sweep(solver, 7), Cost::toOnePercent), bound);
    }

    @ParameterizedTest
    @ValueSource(strings = {"euler", "midpoint", "adams"})
    void undampedVibrationGrowsAtAnyStep(String solver) {
        List<Cost> sweep = sweep(solver, 5);
        assertTrue(sweep.stream().allMatch(cost -> Double.isNaN(cost.toBeStable())));
        List<Chart> charts = StiffGallery.charts(Stream.of(sweep, sweep("rk4", 5)).flatMap(List::stream)
                .toList());
        assertEquals(List.of("rk4"), charts.get(charts.size() - 1).series().stream().map(Series::name).toList());
        Chart never = charts.get(charts.size() - 2);
        assertEquals(List.of(solver), never.rows());
        assertEquals(Series.Mark.FAILURES, never.series().get(0).mark());
        assertEquals(6, never.series().get(0).x().length);
    }

    /** At the lines: the exponents of evaluations, and what is left of the vibration in the stiffest spring. */
    @Test
    void numbersAtTheLinesAreThoseOfTheSweeps() {
        List<Cost> costs = Stream.of(1e3, 1e4, 1e5).map(k -> new Cost(SolverChoice.of("verlet"), k, Math.sqrt(k), k,
                285)).toList();
        List<Chart> charts = StiffGallery.charts(costs);
        assertEquals(List.of("k^1", "k^0.5", "285"),
                charts.stream().map(chart -> chart.series().get(0).end()).toList());
    }

    /** The 1 % is of the slow swing alone: the stiff spring adds a millionth of it, and is at rest but for that. */
    @Test
    void theStiffModeIsAtRest() {
        StiffSpringPair pair = new StiffSpringPair(1e8);
        assertEquals(1, pair.vibration(), 1e-9);
        assertEquals(1, pair.centre());
        assertEquals(1e-6, StiffSpringPair.SEED);
        double[] dSdt = new double[4];
        pair.getStateDerivative(dSdt);
        assertEquals(-1, (dSdt[2] + dSdt[3]) / 2, 1e-12, "the swing does not feel it");
    }
}
