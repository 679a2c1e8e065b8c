package particles.experiments.work;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.experiments.work.StiffCloth.Row;
import particles.view.ChartData;

/** What is said before anything is measured, and said and drawn of times that are given. */
class StiffClothChartTest {
    private static List<Row> rows(String times) {
        return Stream.of(times.split("; ")).map(row -> row.split(" ")).map(row -> new Row(1, Long.parseLong(row[0]),
                Double.parseDouble(row[1]), 1, Double.parseDouble(row[2]), Double.NaN)).toList();
    }

    /** Rows of the steps and the time of rk4, and the time of linearised-euler. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            1 0.001 0.03; 10 0.01 0.04; 100 0.09 0.1; 5000 5 0.1 \
            | rk4 takes less than half the time up to 10 steps, linearised-euler from 5000 on
            3 0.003 0.05; 10 0.03 0.05; 30 0.08 0.2; 300 0.6 0.2; 1000 0.3 0.2; 5000 5 0.1 \
            | rk4 takes less than half the time up to 3 steps, linearised-euler from 5000 on
            1 0.001 0.03; 10 0.01 0.04 | rk4 takes less than half the time up to 10 steps
            5000 5 0.1 | linearised-euler takes less than half the time from 5000 on
            1 0.02 0.03; 10 0.01 0.04; 100 0.09 0.1 \
            | rk4 is not clearly faster on the softest, nor linearised-euler on the stiffest
            """)
    void theFindingSaysWhereRk4IsCheaperAndWhereItIsNot(String times, String finding) {
        assertEquals("One frame of stiff cloth: " + finding, StiffCloth.finding(rows(times)));
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
        ChartData chart = StiffCloth.chart(rows);
        assertEquals(List.of("rk4", "linearised-euler"), chart.series().stream().map(ChartData.Series::name).toList());
        assertArrayEquals(new double[] {1, 5000}, chart.series().get(1).x());
        assertArrayEquals(new double[] {0.03, 0.1}, chart.series().get(1).y());
        assertEquals(50.0, StiffCloth.table(rows).rows().get(1).get(6));
    }
}
