package particles.experiments.work;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import particles.experiments.work.StiffCloth.Row;
import particles.view.Chart;
import particles.view.Panel;
import particles.view.Series;

/** What is said before anything is measured, and said and drawn of times that are given. */
class StiffClothChartTest {
    private static List<Row> rows(String times) {
        return Stream.of(times.split("; ")).map(row -> row.split(" ")).map(row -> new Row(1, Long.parseLong(row[0]),
                Double.parseDouble(row[1]), Double.parseDouble(row[2]))).toList();
    }

    @Test
    void theFirstStepsAreAnnouncedAsWarmUp() {
        assertEquals("warm-up", assertThrows(IllegalStateException.class, () -> StiffCloth.measure(List.of(100L),
                (part, what) -> {
                    throw new IllegalStateException(what);
                })).getMessage());
    }

    @Test
    void bothSolversAreDrawnOverTheStepsOfRk4() {
        List<Row> rows = rows("1 0.001 0.03; 5000 5 0.1");
        Panel panel = StiffCloth.panel(rows);
        Chart chart = panel.charts().get(0);
        assertEquals(List.of("rk4", "linearised-euler"), chart.series().stream().map(Series::name).toList());
        assertArrayEquals(new double[] {1, 5000}, chart.series().get(1).x());
        assertArrayEquals(new double[] {0.03, 0.1}, chart.series().get(1).y());
        assertEquals(50.0, StiffCloth.table(rows).rows().get(1).get(4));
    }
}
