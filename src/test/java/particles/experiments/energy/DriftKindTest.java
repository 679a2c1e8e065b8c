package particles.experiments.energy;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import particles.energy.MinMaxThinning;
import particles.experiments.energy.EnergyDrift.Comparison;
import particles.experiments.energy.EnergyDrift.Drift;
import particles.experiments.energy.EnergyDrift.Kind;
import particles.experiments.runs.SceneRun.Outcome;
import particles.experiments.runs.SceneRun.Setting;
import particles.experiments.runs.SolverChoice;
import particles.view.Chart;
import particles.view.DataTable;
import particles.view.Series;
import particles.view.Series.Mark;

/** The kind of drift of curves whose shape is known, and the numbers at the ends of their lines. */
class DriftKindTest {
    private static final double DURATION = 100;
    private static final int STEPS = 5000;
    /** Errors below are parts of this many joules. */
    private static final double SCALE = 4;

    private static Drift drift(String solver, DoubleUnaryOperator error, double exchanged) {
        return drift(solver, error, exchanged, DURATION, Optional.empty());
    }

    private static Drift drift(String solver, DoubleUnaryOperator error, double exchanged, double end,
                               Optional<String> failure) {
        MinMaxThinning curve = new MinMaxThinning(1024);
        int steps = (int) Math.round(STEPS * end / DURATION);
        for (int k = 0; k <= steps; k++) {
            double time = end * k / steps;
            curve.add(time, SCALE * error.applyAsDouble(time));
        }
        return EnergyDrift.judge(new Setting(SolverChoice.of(solver), end / steps, Optional.empty()),
                curve.points()[0], curve.points()[1], SCALE * exchanged, SCALE,
                new Outcome(end, steps, 4 * steps, 0, failure.isEmpty(), failure));
    }

    private static List<String> ends(Drift... drifts) {
        Comparison comparison = new Comparison(SCALE, List.of(drifts));
        DataTable table = DriftCharts.table(comparison);
        List<String> columns = table.columns().stream().map(DataTable.Column::name).toList();
        for (int k = 0; k < drifts.length; k++) {
            assertEquals(drifts[k].kind().words, table.rows().get(k).get(columns.indexOf("error over time")),
                    "the table has the same kind");
        }
        boolean failed = Stream.of(drifts).anyMatch(drift -> drift.kind() == Kind.FAILED);
        assertEquals(failed, columns.contains("what went wrong"));
        Chart sizes = DriftCharts.sizes(comparison.drifts(), "stopped");
        assertEquals(failed, sizes.series().stream().anyMatch(series -> series.mark() == Mark.FAILURES));
        return sizes.series().stream().filter(series -> series.mark().isCurve()).map(Series::end).toList();
    }

    static Stream<Arguments> cases() {
        DoubleUnaryOperator swing = t -> 2e-3 * Math.sin(3 * t);
        return Stream.of(
                Arguments.of("flat", drift("rk4", t -> 0, 0), Kind.ROUNDING, "\u00b10 %"),
                Arguments.of("round-off that adds up", drift("rk4", t -> 5e-15 * t, 0), Kind.ROUNDING,
                        "\u00b15e-11 %"),
                Arguments.of("drifting up", drift("midpoint", t -> 1.4e-3 * t, 0), Kind.SECULAR, "+14 %"),
                Arguments.of("drifting down, exponentially", drift("backward-euler", t -> Math.expm1(-0.032 * t), 0),
                        Kind.SECULAR, "-96 %"),
                Arguments.of("a very small drift", drift("rk4", t -> -2e-9 * t, 0), Kind.SECULAR,
                        "-2e-5 %"),
                Arguments.of("bounded", drift("verlet", swing, 0), Kind.BOUNDED, "\u00b10.2 %"),
                Arguments.of("a drift that is lost in oscillation",
                        drift("verlet", t -> swing.applyAsDouble(t) + 1e-5 * t, 0), Kind.BOUNDED,
                        "\u00b10.3 %"),
                Arguments.of("a drift beyond the oscillation",
                        drift("rk4", t -> swing.applyAsDouble(t) + 4e-4 * t, 0), Kind.SECULAR, "+3.8 %"),
                Arguments.of("growing a hundredfold", drift("euler", t -> Math.expm1(0.05 * t), 0), Kind.SECULAR,
                        "+15000 %"),
                Arguments.of("blown up", drift("euler", t -> Math.expm1(2 * t), 0, 8, Optional.of("limit")),
                        Kind.FAILED, "until 8 s"),
                Arguments.of("stopped early", drift("verlet", swing, 0, 8, Optional.of("no convergence")),
                        Kind.FAILED, "until 8 s"));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("cases")
    void undampedRunsAreToldByShapeAndSize(String shape, Drift drift, Kind kind, String words) {
        assertEquals(kind, drift.kind());
        assertEquals(List.of(words), ends(drift));
    }

    /** A damped motion's error settles as the motion does, and a driven one's follows the force: no drift either. */
    @Test
    void dampedAndDrivenRunsHaveASizeAndNoDrift() {
        Drift damped = drift("rk4", t -> -1.8e-6 * Math.expm1(-t), 0.9);
        Drift driven = drift("verlet", t -> 1.7e-5 * t, 40);
        assertEquals(Kind.EXCHANGING, damped.kind());
        assertEquals(Kind.EXCHANGING, driven.kind());
        assertEquals(List.of("\u00b10.00018 %", "\u00b10.17 %"), ends(damped, driven));
    }

    /** A curve that is nearly straight is called a drift without damping, and only a size with it. */
    @Test
    void sameCurveIsNoDriftOnceTheSceneIsDamped() {
        DoubleUnaryOperator line = t -> 1e-4 * t;
        assertEquals(Kind.SECULAR, drift("rk4", line, 0).kind());
        assertEquals(Kind.SECULAR, drift("rk4", line, 1e-13).kind(), "round-off is not damping");
        assertEquals(Kind.EXCHANGING, drift("rk4", line, 1e-6).kind());
    }

    /** The linear chart ends at 10 %, and has percent as the other one. */
    @Test
    void smallErrorsAreDrawnAsLongAsTheyAreSmall() {
        Chart small = DriftCharts.small(new Comparison(SCALE, List.of(drift("midpoint",
                t -> 1.4e-3 * t, 0))));
        double[] percent = small.series().get(0).y();
        assertEquals(10, percent[percent.length - 1], 0.03);
        assertEquals(0.14 * small.series().get(0).x()[percent.length - 1], percent[percent.length - 1], 1e-12);
    }
}
