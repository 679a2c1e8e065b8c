package particles.experiments.work;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import particles.experiments.work.StiffCloth.Row;
import particles.view.ChartData;

/** What is said and drawn of times that are given. */
class StiffClothChartTest {
    private static final Row SOFT = new Row(10, 1, 0.001, 0.04, 0.03, 0.09);
    private static final Row MIDDLE = new Row(1000, 10, 0.01, 0.05, 0.04, Double.NaN);
    private static final Row EQUAL = new Row(1e5, 100, 0.09, 0.1, 0.1, Double.NaN);
    private static final Row STIFF = new Row(1e9, 5000, 5, 0.2, 0.1, Double.NaN);

    @Test
    void theFindingSaysWhereRk4IsCheaperAndWhereItIsNot() {
        assertEquals("One frame of stiff cloth: rk4 takes less than half the time up to 10 steps,"
                + " linearised-euler from 5000 on", StiffCloth.finding(List.of(SOFT, MIDDLE, EQUAL, STIFF)));
        assertEquals("One frame of stiff cloth: rk4 takes less than half the time up to 10 steps",
                StiffCloth.finding(List.of(SOFT, MIDDLE)));
        assertEquals("One frame of stiff cloth: linearised-euler takes less than half the time from 5000 on",
                StiffCloth.finding(List.of(STIFF)));
        assertEquals("One frame of stiff cloth: both take about as long", StiffCloth.finding(List.of(EQUAL)));
    }

    @Test
    void bothSolversAreDrawnOverTheStepsOfRk4() {
        ChartData chart = StiffCloth.chart(List.of(SOFT, STIFF));
        assertEquals(List.of("rk4", "linearised-euler"), chart.series().stream().map(ChartData.Series::name).toList());
        assertArrayEquals(new double[] {1, 5000}, chart.series().get(1).x());
        assertArrayEquals(new double[] {0.03, 0.1}, chart.series().get(1).y());
        assertEquals(50.0, StiffCloth.table(List.of(STIFF)).rows().get(0).get(6));
    }
}
