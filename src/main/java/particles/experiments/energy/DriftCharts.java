package particles.experiments.energy;

import static particles.view.DataTable.column;

import deSolvers.text.Digits;
import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import particles.experiments.energy.EnergyDrift.Comparison;
import particles.experiments.energy.EnergyDrift.Drift;
import particles.experiments.runs.SceneRun.Outcome;
import particles.view.Axis;
import particles.view.Chart;
import particles.view.DataTable;
import particles.view.Series;
import particles.view.Series.Mark;

/** The energy drift of several solvers as charts and as a table. */
public final class DriftCharts {
    /** The linear chart ends at this part of the energy scale (%). */
    private static final double LINEAR = 10;
    /** Smaller errors than this part of the largest one drawn are a straight line at 0. */
    private static final double SEEN = 0.01;
    /** An error that is small for less than this part of the longest time is a stroke upwards or downwards. */
    private static final double LASTS = 0.05;
    private static final double PERCENT = 100;
    private static final double SMALLEST = 1e-15;
    private static final String UNIT = "% of scale";

    private DriftCharts() {
    }

    /**
     * @param drifts the measured drifts
     * @return the size of all errors on a logarithmic axis
     */
    public static Chart sizes(List<Drift> drifts) {
        return new Chart(Axis.TIME, Axis.log("|energy error|", UNIT), drifts.stream().flatMap(drift -> toItsEnd(
                line(drift, percent(drift).map(Math::abs).map(e -> e < SMALLEST ? Double.NaN : e)), drift.outcome()))
                .toList());
    }

    /**
     * @param line    a curve over time
     * @param outcome the outcome of its run
     * @return the curve, and a cross at its end if the run ended early
     */
    public static Stream<Series> toItsEnd(Series line, Outcome outcome) {
        int last = line.last();
        return outcome.whole() || last < 0 ? Stream.of(line) : Stream.of(line, Series.point(line.look(), "stopped",
                Mark.FAILURES, line.x()[last], line.y()[last]));
    }

    /**
     * @param drifts the measured drifts
     * @return the errors with their signs on a linear axis, each while it is small; without those that are too small
     *         to be seen beside the others, or leave the axis at once
     */
    public static Chart small(List<Drift> drifts) {
        double top = drifts.stream().mapToDouble(DriftCharts::shown).max().orElse(0);
        List<Series> lines = drifts.stream().filter(drift -> shown(drift) >= SEEN * top)
                .map(drift -> line(drift, percent(drift).takeWhile(e -> Math.abs(e) <= LINEAR))).toList();
        double longest = lines.stream().mapToDouble(DriftCharts::end).max().orElse(0);
        return new Chart(Axis.TIME, Axis.linear("energy error", UNIT), lines.stream()
                .filter(line -> end(line) >= LASTS * longest).toList());
    }

    private static double end(Series line) {
        return line.x()[line.x().length - 1];
    }

    private static double shown(Drift drift) {
        return Math.min(LINEAR, PERCENT * Math.abs(drift.extreme()));
    }

    private static DoubleStream percent(Drift drift) {
        return Arrays.stream(drift.error()).map(e -> PERCENT * e);
    }

    private static Series line(Drift drift, DoubleStream percent) {
        double[] error = percent.toArray();
        return new Series(drift.look(), drift.label(), Mark.LINE, Arrays.copyOf(drift.time(), error.length), error)
                .ending(drift.outcome().whole() ? (drift.extreme() > 0 ? "+" : "")
                        + Digits.few(PERCENT * drift.extreme(), 2) + " %"
                        : "until " + Digits.few(drift.outcome().endTime()) + " s");
    }

    /**
     * @param comparison the measured drifts
     * @return a row for each solver; failures have a column only if there are any
     */
    public static DataTable table(Comparison comparison) {
        return DataTable.of("drift", "Energy error in percent of the energy scale, "
                + Digits.few(comparison.scale(), 4) + " J", comparison.drifts(), column("solver", Drift::label),
                column("deltaT (s)", drift -> drift.setting().deltaT()),
                column("error at the end (%)", 2, drift -> PERCENT * drift.end()),
                column("largest error (%)", 2, drift -> PERCENT * drift.extreme()),
                column("fitted slope (%/s)", 3, drift -> PERCENT * drift.slope()),
                column("evaluations", drift -> drift.outcome().evaluations()),
                column("CPU time (s)", 2, drift -> drift.outcome().seconds()),
                column("what went wrong", drift -> drift.outcome().failure().orElse(""))).withoutEmptyColumns();
    }
}
