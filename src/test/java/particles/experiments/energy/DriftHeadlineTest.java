package particles.experiments.energy;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
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
import particles.view.DataTable;

/** What the headline says of curves whose shape is known, and that it says what the table says. */
class DriftHeadlineTest {
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

    private static String headline(Drift... drifts) {
        Comparison comparison = new Comparison("Scene", SCALE, false, false, List.of(drifts));
        DataTable table = DriftCharts.table(comparison);
        List<String> columns = table.columns().stream().map(DataTable.Column::name).toList();
        for (int k = 0; k < drifts.length; k++) {
            assertEquals(drifts[k].kind().words, table.rows().get(k).get(columns.indexOf("error over time")),
                    "the table has the same verdict");
        }
        assertFalse(columns.contains("tolerance"), "a column that would be empty");
        boolean failed = Stream.of(drifts).anyMatch(drift -> drift.kind() == Kind.FAILED);
        assertEquals(failed, columns.contains("what went wrong"));
        return DriftCharts.finding(comparison);
    }

    static Stream<Arguments> cases() {
        DoubleUnaryOperator swing = t -> 2e-3 * Math.sin(3 * t);
        return Stream.of(
                Arguments.of("flat", drift("rk4", t -> 0, 0), Kind.ROUNDING, "rk4 is exact to round-off"),
                Arguments.of("round-off that adds up", drift("rk4", t -> 5e-15 * t, 0), Kind.ROUNDING,
                        "rk4 is exact to round-off"),
                Arguments.of("drifting up", drift("midpoint", t -> 1.4e-3 * t, 0), Kind.SECULAR, "midpoint gains 14 %"),
                Arguments.of("drifting down, exponentially", drift("backward-euler", t -> Math.expm1(-0.032 * t), 0),
                        Kind.SECULAR, "backward-euler loses 96 %"),
                Arguments.of("a very small drift", drift("rk4", t -> -2e-9 * t, 0), Kind.SECULAR,
                        "rk4 loses 2e-5 %"),
                Arguments.of("bounded", drift("verlet", swing, 0), Kind.BOUNDED, "verlet stays within 0.2 %"),
                Arguments.of("a drift that is lost in oscillation",
                        drift("verlet", t -> swing.applyAsDouble(t) + 1e-5 * t, 0), Kind.BOUNDED,
                        "verlet stays within 0.3 %"),
                Arguments.of("a drift beyond the oscillation",
                        drift("rk4", t -> swing.applyAsDouble(t) + 4e-4 * t, 0), Kind.SECULAR, "rk4 gains 3.8 %"),
                Arguments.of("growing a hundredfold", drift("euler", t -> Math.expm1(0.05 * t), 0), Kind.SECULAR,
                        "euler gains 150 times the energy"),
                Arguments.of("blown up", drift("euler", t -> Math.expm1(2 * t), 0, 8, Optional.of("limit")),
                        Kind.FAILED, "euler blows up at t = 8 s"),
                Arguments.of("stopped early", drift("verlet", swing, 0, 8, Optional.of("no convergence")),
                        Kind.FAILED, "verlet stops at t = 8 s"));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("cases")
    void undampedRunsAreToldByShapeAndSize(String shape, Drift drift, Kind kind, String words) {
        assertEquals(kind, drift.kind());
        assertEquals("Scene: " + words, headline(drift));
    }

    /** The larger error comes first, although the smaller one grows with time and the larger one does not. */
    @Test
    void worstComesFirst() {
        assertEquals("Scene: euler blows up at t = 8 s; midpoint gains 14 %; verlet stays within 0.2 %;"
                + " rk4 gains 0.00018 %; implicit-midpoint is exact to round-off",
                headline(drift("implicit-midpoint", t -> 0, 0), drift("rk4", t -> 1.8e-8 * t, 0),
                        drift("verlet", t -> 2e-3 * Math.sin(3 * t), 0), drift("midpoint", t -> 1.4e-3 * t, 0),
                        drift("euler", t -> Math.expm1(2 * t), 0, 8, Optional.of("limit"))));
    }

    /** Four are named; of the others, those that failed are not said to be off by so little. */
    @Test
    void thoseThatStopAreNotAmongTheBest() {
        List<Drift> drifts = new ArrayList<>();
        for (String solver : List.of("euler", "midpoint", "rk4", "adams", "yoshida4", "symplectic-euler")) {
            drifts.add(drift(solver, t -> 0.01, 0, drifts.size() + 1, Optional.of("no convergence")));
        }
        drifts.add(drift("verlet", t -> 2e-3 * Math.sin(3 * t), 0));
        assertEquals("Scene: euler stops at t = 1 s; midpoint stops at t = 2 s; rk4 stops at t = 3 s; adams stops at"
                + " t = 4 s; 2 more stop early; verlet stays within 0.2 %",
                headline(drifts.toArray(Drift[]::new)));
    }

    @Test
    void workIsEqualIfItIs() {
        for (double end : new double[] {DURATION, 0.95 * DURATION, DURATION / 2}) {
            assertTrue(DriftCharts.finding(new Comparison("Scene", SCALE, true, false, List.of(drift("rk4", t -> 0, 0),
                    drift("verlet", t -> 0, 0, end, Optional.empty()),
                    drift("euler", t -> 0, 0, 1, Optional.of("limit"))))).endsWith(end < 0.9 * DURATION
                    ? " (10000 to 20000 evaluations)" : " (equal evaluations)"), "until " + end);
        }
    }

    /** A damped motion's error settles as the motion does, and a driven one's follows the force: no drift either. */
    @Test
    void dampedAndDrivenRunsAreRankedBySize() {
        Drift damped = drift("rk4", t -> -1.8e-6 * Math.expm1(-t), 0.9);
        Drift driven = drift("verlet", t -> 1.7e-5 * t, 40);
        assertEquals(Kind.EXCHANGING, damped.kind());
        assertEquals(Kind.EXCHANGING, driven.kind());
        assertEquals("Scene, numerical energy error: verlet +0.17 %; rk4 +0.00018 %", headline(damped, driven));
    }

    /** A curve that is nearly straight is called a drift without damping, and only a size with it. */
    @Test
    void sameCurveIsNoDriftOnceTheSceneIsDamped() {
        DoubleUnaryOperator line = t -> 1e-4 * t;
        assertEquals(Kind.SECULAR, drift("rk4", line, 0).kind());
        assertEquals(Kind.SECULAR, drift("rk4", line, 1e-13).kind(), "round-off is not damping");
        assertEquals(Kind.EXCHANGING, drift("rk4", line, 1e-6).kind());
    }

    @Test
    void manySolversShareTheLastPlace() {
        Drift[] drifts = Stream.of("euler", "midpoint", "rk4", "verlet", "yoshida4", "adams", "step-doubling",
                        "dormand-prince")
                .map(name -> drift(name, t -> 1e-2 / name.length() * Math.sin(3 * t), 0)).toArray(Drift[]::new);
        assertEquals("Scene: rk4 stays within 0.33 %; euler and adams stay within 0.2 %; verlet stays within"
                + " 0.17 %; midpoint and yoshida4 stay within 0.12 %; the other 2 are off by at most"
                + " 0.077 %", headline(drifts));
    }
}
