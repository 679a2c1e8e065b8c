package particles.experiments.work;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import particles.experiments.work.EffectCost.Cost;
import particles.scene.Scene;
import particles.scene.format.SceneFormat;
import particles.spec.Reference;
import particles.view.Chart;

/** The measurement, by a clock of the test's own. */
class EffectCostTest {

    /**
     * The clock gives 100 ns to the first turn, 200 to the second ...; the later round is slower and does not count.
     */
    @Test
    void theFastestRoundOfEachCounts() {
        long[] now = {0};
        int[] call = {0};
        List<String> told = new ArrayList<>();
        List<Cost> costs = EffectCost.measure(3, 2, 2, () -> 1e-9 * (now[0] += 100L * (call[0]++ / 2 + 1)),
                (part, what) -> told.add(what));
        assertEquals(21, costs.size());
        assertEquals(42, told.size());
        for (int k = 0; k < 21; k++) {
            assertEquals(100e-9 * (k + 1) / 2, costs.get(k).seconds(), 1e-19);             // measured 3e-21
            assertEquals(k + 1, costs.get(k).overBase(), 1e-12);                      // measured 4e-14
            assertEquals(costs.get(k).name(), told.get(k));
        }
        Chart chart = EffectCost.panel(costs).charts().get(0);
        assertEquals(EffectCost.ROWS, chart.rows().size());
        assertEquals(21, EffectCost.table(costs).rows().size());
        assertEquals(1.0, (double) EffectCost.table(costs).rows().get(0).get(2));
    }

    /** Every round goes on where the last one ended, so that each makes its steps. */
    @Test
    void eachRoundMakesItsSteps() {
        Scene cloth = EffectCost.scene(3, 12, "");
        Runnable round = EffectCost.round(cloth, 4);
        for (int k = 1; k <= 3; k++) {
            round.run();
            assertEquals(k * 4e-3, cloth.system().getTime());
            assertEquals(4 * k, cloth.simulation().getSteps());
        }
    }

    /** The scene format lists all effects; wind acts through drag, and turbulence too. */
    @Test
    void everyEffectOfTheSceneFormatIsMeasured() {
        Matcher list = Pattern.compile("(?m)^\\| `effects` \\| a list of: ([^|]*?), or the full name")
                .matcher(Reference.of(SceneFormat.SCENE, "###"));
        assertTrue(list.find());
        String measured = EffectCost.measure(2, 1, 1, () -> 0, (part, what) -> { }).stream().map(Cost::name)
                .collect(Collectors.joining(",")).replace(" ", "").toLowerCase(Locale.ROOT);
        for (String effect : list.group(1).replace("`", "").toLowerCase(Locale.ROOT).split(", ")) {
            assertTrue(measured.contains(effect), effect);
        }
    }

    /** Sorted whatever the order of measurement, on a logarithmic axis, with the value in the row's name. */
    @Test
    void rowsAreSortedAndCarryTheirValues() {
        Chart chart = EffectCost.panel(List.of(new Cost("springs", 1e-6, 1), new Cost("+ cohesion", 2.8e-5, 28),
                new Cost("+ tear", 1.3e-6, 1.3))).charts().get(0);
        assertEquals(List.of("springs: 1", "+ tear: 1.3", "+ cohesion: 28"), chart.rows());
        assertTrue(chart.x().log());
        assertArrayEquals(new double[] {1, 1.3, 28}, chart.series().get(0).x());
        assertArrayEquals(new double[] {0, 1, 2}, chart.series().get(0).y());
    }
}
