package particles.experiments;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import particles.ChartData;
import particles.ChartData.Mark;
import particles.ChartData.Series;
import particles.DataTable;
import particles.experiments.StiffGallery.Cost;
import particles.experiments.StiffGallery.Sweep;

/** The stiff gallery as charts and as a table. */
public final class StiffCharts {
    private static final double GONE = 1e-16;

    private StiffCharts() {
    }

    /**
     * @param sweeps one a solver
     * @return over the stiffness: evaluations for 1 %, evaluations to be stable, and what is left of the vibration
     */
    public static List<ChartData> charts(List<Sweep> sweeps) {
        return List.of(chart(sweeps, "Where stability sets the step, cost grows as the root of the stiffness; implicit stays flat",
                "evaluations for 1 %", Cost::toOnePercent),
                chart(sweeps, "", "evaluations to be stable", Cost::toBeStable),
                chart(sweeps, "", "vibration left (energy)", cost -> Math.max(GONE, cost.vibrationLeft())));
    }

    private static ChartData chart(List<Sweep> sweeps, String title, String label, ToDoubleFunction<Cost> what) {
        List<Series> series = new ArrayList<>();
        List<Double> crosses = new ArrayList<>();
        double most = 1;
        for (Sweep sweep : sweeps) {
            series.add(new Series(sweep.solver().label(), Mark.LINE_AND_POINTS,
                    sweep.costs().stream().mapToDouble(Cost::stiffness).toArray(), sweep.costs().stream().mapToDouble(what).toArray()));
            for (Cost cost : sweep.costs()) {
                boolean none = what.applyAsDouble(cost) != what.applyAsDouble(cost);
                if (none && !sweep.solver().adaptive()) {
                    crosses.add(cost.stiffness());
                }
                most = Math.max(most, none ? 1 : what.applyAsDouble(cost));
            }
        }
        if (!crosses.isEmpty()) {
            double top = 3 * most;
            series.add(new Series("no number of steps is enough", Mark.FAILURES,
                    crosses.stream().mapToDouble(Double::doubleValue).toArray(), crosses.stream().mapToDouble(k -> top).toArray()));
        }
        return new ChartData(title, "stiffness of the spring between the masses (N/m)", label, true, true, series);
    }

    /**
     * @param sweeps one a solver
     * @return exponents, and what the stiffest spring costs
     */
    public static DataTable table(List<Sweep> sweeps) {
        List<List<Object>> rows = new ArrayList<>();
        for (Sweep sweep : sweeps) {
            Cost soft = sweep.costs().get(0);
            Cost stiff = sweep.costs().get(sweep.costs().size() - 1);
            rows.add(List.of(sweep.solver().label(), sweep.neverStable() ? "never: grows at any step"
                    : sweep.solver().adaptive() ? "by its tolerance" : "from some step on", sweep.stableExponent(), sweep.preciseExponent(),
                    soft.toOnePercent(), stiff.toOnePercent(), stiff.vibrationLeft()));
        }
        return new DataTable("stiffness", "Cost as a power of the stiffness, and evaluations for 1 % with the softest and the stiffest spring",
                List.of(DataTable.column("solver"), DataTable.column("stable"), new DataTable.Column("exponent, stable", 3),
                        new DataTable.Column("exponent, 1 %", 3), DataTable.column("softest"), DataTable.column("stiffest"),
                        new DataTable.Column("vibration left", 2)), rows);
    }
}
