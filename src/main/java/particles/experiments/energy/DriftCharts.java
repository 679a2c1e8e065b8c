package particles.experiments.energy;

import static particles.view.DataTable.column;

import deSolvers.text.Digits;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;
import particles.experiments.energy.EnergyDrift.Comparison;
import particles.experiments.energy.EnergyDrift.Drift;
import particles.experiments.energy.EnergyDrift.Kind;
import particles.view.Axis;
import particles.view.Chart;
import particles.view.DataTable;
import particles.view.Series;
import particles.view.Series.Mark;

/** The energy drift of several solvers as charts and as a table. */
public final class DriftCharts {
    /** The linear chart ends at this part of the energy scale (%). */
    private static final double LINEAR = 10;
    private static final double PERCENT = 100;
    private static final double SMALLEST = 1e-15;
    private static final String UNIT = "% of scale";

    private DriftCharts() {
    }

    /**
     * @param drifts  the measured drifts
     * @param stopped the name of the crosses where a run ended early
     * @return the size of all errors on a logarithmic axis
     */
    public static Chart sizes(List<Drift> drifts, String stopped) {
        List<Series> series = new ArrayList<>();
        for (Drift drift : drifts) {
            series.add(line(drift, Arrays.stream(drift.error()).map(e -> PERCENT * Math.abs(e)).map(e ->
                    e < SMALLEST ? Double.NaN : e)));
            if (drift.kind() == Kind.FAILED) {
                series.add(Series.point(drift.look(), stopped, Mark.FAILURES,
                        drift.time()[drift.time().length - 1], Math.max(SMALLEST, PERCENT * Math.abs(drift.end()))));
            }
        }
        return new Chart(Axis.TIME, Axis.log("|energy error|", UNIT), series);
    }

    /**
     * @param comparison the measured drifts
     * @return the errors with their signs on a linear axis, each while it is small
     */
    public static Chart small(Comparison comparison) {
        return new Chart(Axis.TIME, Axis.linear("energy error", UNIT), comparison.drifts().stream().map(drift ->
                line(drift, Arrays.stream(drift.error()).map(e -> PERCENT * e).takeWhile(e -> Math.abs(e) <= LINEAR)))
                .toList());
    }

    private static Series line(Drift drift, DoubleStream percent) {
        double[] error = percent.toArray();
        return new Series(drift.look(), drift.label(), Mark.LINE, Arrays.copyOf(drift.time(), error.length), error)
                .ending(end(drift));
    }

    /** The error at the end, or the size of one that goes up and down; of a run that ended early, the time. */
    private static String end(Drift drift) {
        String size = Digits.few(PERCENT * (drift.kind() == Kind.SECULAR ? Math.abs(drift.end()) : drift.largest()), 2);
        return drift.kind() == Kind.FAILED ? "until " + Digits.few(drift.outcome().endTime()) + " s"
                : (drift.kind() != Kind.SECULAR ? "\u00b1" : drift.end() < 0 ? "-" : "+") + size + " %";
    }

    /**
     * @param comparison the measured drifts
     * @return a row for each solver; failures have a column only if there are any
     */
    public static DataTable table(Comparison comparison) {
        return DataTable.of("drift", "Numerical energy error in percent of the energy scale of an accurate run, "
                + Digits.few(comparison.scale(), 4) + " J", comparison.drifts(), column("solver", Drift::label),
                column("deltaT (s)", drift -> drift.setting().deltaT()),
                column("end drift (%)", 2, drift -> PERCENT * drift.end()),
                column("largest (%)", 2, drift -> PERCENT * drift.extreme()),
                column("slope (%/s)", 3, drift -> PERCENT * drift.slope()),
                column("error over time", drift -> drift.kind().words),
                column("evaluations", drift -> drift.outcome().evaluations()),
                column("CPU time (s)", 2, drift -> drift.outcome().seconds()),
                column("what went wrong", drift -> drift.outcome().failure().orElse(""))).withoutEmptyColumns();
    }
}
