package particles.experiments.energy;

import static particles.view.DataTable.column;

import deSolvers.text.Digits;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import particles.experiments.energy.EnergyDrift.Comparison;
import particles.experiments.energy.EnergyDrift.Drift;
import particles.experiments.energy.EnergyDrift.Kind;
import particles.view.ChartData;
import particles.view.ChartData.Mark;
import particles.view.ChartData.Series;
import particles.view.DataTable;

/** Charts and table of the energy drift of several solvers. */
public final class DriftCharts {
    /** The name of the crosses in the legend. */
    public static final String STOPPED = "stopped";
    /** The linear chart ends at this part of the energy scale. */
    private static final double LINEAR = 0.1;
    private static final double SMALLEST = 1e-17;

    private DriftCharts() {
    }

    /**
     * @param comparison the measured drifts
     * @return two charts over the same time: small errors on a linear axis, and the size of all errors on a logarithmic
     *         one
     */
    public static List<ChartData> charts(Comparison comparison) {
        List<Series> linear = new ArrayList<>();
        List<Series> logarithmic = new ArrayList<>();
        List<double[]> failures = new ArrayList<>();
        for (Drift drift : comparison.drifts()) {
            double[] error = drift.error();
            int n = (int) Arrays.stream(error).takeWhile(e -> Math.abs(e) <= LINEAR).count();
            linear.add(new Series(drift.label(), Mark.LINE, Arrays.copyOf(drift.time(), n), Arrays.copyOf(error, n)));
            logarithmic.add(new Series(drift.label(), Mark.LINE, drift.time(), Arrays.stream(error).map(Math::abs)
                    .map(e -> e < SMALLEST ? Double.NaN : e).toArray()));
            if (drift.kind() == Kind.FAILED) {
                failures.add(new double[] {drift.time()[error.length - 1], Math.max(SMALLEST, Math.abs(drift.end()))});
            }
        }
        if (!failures.isEmpty()) {
            logarithmic.add(Series.of(STOPPED, Mark.FAILURES, failures));
        }
        return List.of(new ChartData(DriftHeadline.of(comparison), "time (s)",
                        "|energy error| / scale", false, true, logarithmic),
                new ChartData(DriftHeadline.within(LINEAR, comparison), "time (s)",
                        "energy error / scale", false, false, linear));
    }

    /**
     * @param comparison the measured drifts
     * @return a row for each solver; tolerances and failures have a column only if there are any
     */
    public static DataTable table(Comparison comparison) {
        return DataTable.of("drift", "Numerical energy error as a part of the energy scale of an accurate run, "
                + Digits.few(comparison.scale(), 4) + " J", comparison.drifts(), column("solver", Drift::label),
                column("deltaT (s)", drift -> drift.setting().deltaT()),
                column("tolerance", drift -> drift.setting().tolerance().orElse(Double.NaN)),
                column("end drift", 2, Drift::end), column("largest", 2, Drift::extreme),
                column("slope (1/s)", 3, Drift::slope), column("error over time", drift -> drift.kind().words()),
                column("evaluations", drift -> drift.outcome().evaluations()),
                column("CPU time (s)", 2, drift -> drift.outcome().seconds()),
                column("why it ended", drift -> drift.outcome().failure().orElse(""))).withoutEmptyColumns();
    }
}
