package particles.experiments.energy;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import particles.experiments.energy.EnergyDrift.Comparison;
import particles.experiments.energy.EnergyDrift.Drift;
import particles.experiments.runs.SceneRun.Outcome;
import particles.experiments.runs.SceneRun.Setting;
import particles.experiments.runs.SolverChoice;
import particles.view.Chart;
import particles.view.DataTable;
import particles.view.Series;
import particles.view.Series.Mark;

/** Errors whose course is known, over 100 s or until they fail. */
class DriftChartsTest {
    private static final int STEPS = 5000;
    private static final Drift UP = drift("midpoint", t -> 1.4e-3 * t, 100, "");
    private static final Drift DOWN = drift("backward-euler", t -> Math.expm1(-0.032 * t), 100, "");
    private static final Drift SWING = drift("verlet", t -> -2e-3 * Math.sin(3 * t), 100, "");
    private static final Drift TINY = drift("rk4", t -> -2e-9 * t, 100, "");
    private static final Drift NONE = drift("radau", t -> 0, 100, "");
    private static final Drift FAILED = drift("euler", t -> Math.expm1(2 * t), 8, "limit");

    private static Drift drift(String solver, DoubleUnaryOperator error, double end, String failure) {
        double[] time = IntStream.rangeClosed(0, STEPS).mapToDouble(k -> end * k / STEPS).toArray();
        return new Drift(Setting.of(SolverChoice.of(solver), end / STEPS), time,
                IntStream.rangeClosed(0, STEPS).mapToDouble(k -> error.applyAsDouble(time[k])).toArray(),
                new Outcome(end, STEPS, 4 * STEPS, 0, failure.isEmpty(), failure.isEmpty() ? Optional.empty()
                        : Optional.of(failure)));
    }

    private static List<String> columns(Drift... drifts) {
        return DriftCharts.table(new Comparison(4, List.of(drifts))).columns().stream().map(DataTable.Column::name)
                .toList();
    }

    @Test
    void theLargestErrorStandsAtItsCurveWithItsSign() {
        Chart sizes = DriftCharts.sizes(List.of(UP, DOWN, SWING, TINY, NONE, FAILED));
        assertEquals(List.of("+14 %", "-96 %", "-0.2 %", "-2e-5 %", "0 %", "until 8 s"), sizes.series().stream()
                .filter(series -> series.mark().isCurve()).map(Series::end).toList());
    }

    @Test
    void aRunThatFailsHasACrossAtItsEndAndAColumnForTheReason() {
        List<Series> series = DriftCharts.sizes(List.of(UP, FAILED)).series();
        assertEquals(List.of(Mark.LINE, Mark.LINE, Mark.FAILURES), series.stream().map(Series::mark).toList());
        assertArrayEquals(new double[] {8}, series.get(2).x());
        assertEquals(1, columns(UP, FAILED).size() - columns(UP).size());
    }

    /** The linear chart ends at 10 %, and has percent as the other one. */
    @Test
    void smallErrorsAreDrawnAsLongAsTheyAreSmall() {
        Series small = DriftCharts.small(List.of(UP)).series().get(0);
        double[] percent = small.y();
        assertEquals(10, percent[percent.length - 1], 0.03);
        assertEquals(0.14 * small.x()[percent.length - 1], percent[percent.length - 1], 1e-12);
    }

    /** Of 10 % a hundredth can be seen; where nothing is larger, all can. */
    @Test
    void whatCannotBeSeenBesideTheOthersIsLeftOut() {
        assertEquals(List.of("midpoint", "verlet"), names(UP, SWING, TINY, NONE));
        assertEquals(List.of("rk4"), names(TINY, NONE));
        assertEquals(List.of("radau"), names(NONE));
        assertEquals(List.of("midpoint"), names(UP, DOWN, FAILED), "the others leave the axis at once");
        assertEquals(List.of("euler"), names(FAILED));
    }

    private static List<String> names(Drift... drifts) {
        return DriftCharts.small(List.of(drifts)).series().stream().map(Series::name).toList();
    }
}
