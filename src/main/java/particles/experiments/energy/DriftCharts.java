package particles.experiments.energy;

import java.math.BigDecimal;
import java.math.MathContext;
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
            String name = drift.setting().solver().label();
            int n = 0;
            while (n < drift.error().length && Math.abs(drift.error()[n]) <= LINEAR) {
                n++;
            }
            linear.add(new Series(name, Mark.LINE, Arrays.copyOf(drift.time(), n), Arrays.copyOf(drift.error(), n)));
            double[] size = Arrays.stream(drift.error()).map(e -> Math.abs(e) < SMALLEST ? Double.NaN
                    : Math.abs(e)).toArray();
            logarithmic.add(new Series(name, Mark.LINE, drift.time(), size));
            if (drift.kind() == Kind.FAILED) {
                failures.add(new double[] {drift.time()[drift.time().length - 1], Math.max(SMALLEST,
                        Math.abs(drift.end()))});
            }
        }
        if (!failures.isEmpty()) {
            logarithmic.add(new Series(STOPPED, Mark.FAILURES, failures.stream().mapToDouble(f -> f[0]).toArray(),
                    failures.stream().mapToDouble(f -> f[1]).toArray()));
        }
        return List.of(new ChartData(drawn -> DriftHeadline.of(comparison.of(drawn)), "time (s)",
                        "|energy error| / scale", false, true, logarithmic),
                new ChartData(drawn -> DriftHeadline.within(LINEAR, comparison.of(drawn)), "time (s)",
                        "energy error / scale", false, false, linear));
    }

    /**
     * @param comparison the measured drifts
     * @return a sentence that names each error with its size, the worst first
     */
    public static String finding(Comparison comparison) {
        return DriftHeadline.of(comparison);
    }

    /**
     * @param comparison the measured drifts
     * @return a row for each solver; tolerances and failures have a column only if there are any
     */
    public static DataTable table(Comparison comparison) {
        List<List<Object>> rows = new ArrayList<>();
        for (Drift drift : comparison.drifts()) {
            rows.add(List.of(drift.setting().solver().label(), drift.setting().deltaT(),
                    drift.setting().tolerance().orElse(Double.NaN), drift.end(), drift.extreme(), drift.slope(),
                    drift.kind().words(), drift.outcome().evaluations(),
                    drift.outcome().seconds(),
                    drift.outcome().failure().orElse("")));
        }
        String scale = new BigDecimal(comparison.scale()).round(new MathContext(4)).stripTrailingZeros()
                .toPlainString();
        return new DataTable("drift",
                "Numerical energy error as a part of the energy scale of an accurate run, " + scale + " J",
                List.of(DataTable.column("solver"), DataTable.column("deltaT (s)"), DataTable.column("tolerance"),
                        new DataTable.Column("end drift", 3), new DataTable.Column("largest", 3),
                        new DataTable.Column("slope (1/s)", 3), DataTable.column("error over time"),
                        DataTable.column("evaluations"),
                        new DataTable.Column("time (s)", 2), DataTable.column("why it ended")), rows)
                .withoutEmptyColumns();
    }
}
