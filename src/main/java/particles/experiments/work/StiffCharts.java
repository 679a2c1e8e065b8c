package particles.experiments.work;

import static particles.view.DataTable.column;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.function.ToDoubleFunction;
import particles.experiments.work.StiffGallery.Cost;
import particles.experiments.work.StiffGallery.Sweep;
import particles.view.ChartData;
import particles.view.ChartData.Mark;
import particles.view.ChartData.Series;
import particles.view.DataTable;

/** Charts and table of the stiff gallery. */
public final class StiffCharts {
    private static final String STIFFNESS = "stiffness k (N/m)";
    /** Smaller values are drawn as this one: the vibration is gone. */
    private static final double GONE = 1e-16;

    private StiffCharts() {
    }

    /**
     * @param sweeps the sweep of each solver
     * @return charts over the stiffness: evaluations for an error of 1 %; solvers that are never stable or never reach
     *         1 %, if there are any; evaluations needed to be stable; the rest of the vibration for stable runs
     */
    public static List<ChartData> charts(List<Sweep> sweeps) {
        List<Series> precise = new ArrayList<>();
        List<Series> stable = new ArrayList<>();
        List<Series> left = new ArrayList<>();
        for (Sweep sweep : sweeps) {
            precise.add(series(sweep, Cost::toOnePercent));
            if (!sweep.neverStable() && !sweep.solver().adaptive()) {
                stable.add(series(sweep, Cost::toBeStable));
            }
            if (!sweep.neverStable() && (!sweep.solver().adaptive() || sweep.solver().implicit())) {
                left.add(series(sweep, cost -> Math.max(GONE, cost.vibrationLeft())));
            }
        }
        List<ChartData> charts = new ArrayList<>();
        charts.add(new ChartData(finding(sweeps), STIFFNESS, "evaluations for 1 %", true, true, precise));
        List<String> rows = sweeps.stream().filter(sweep -> sweep.neverStable()
                || sweep.costs().stream().anyMatch(cost ->
                        Double.isNaN(cost.toOnePercent()))).map(StiffCharts::name).toList();
        if (!rows.isEmpty()) {
            charts.add(new ChartData("", STIFFNESS, "never", true, false, rows, failures(sweeps, rows)));
        }
        if (!stable.isEmpty()) {
            charts.add(new ChartData("Cost of a run that only has to be stable", STIFFNESS,
                    "evaluations to be stable", true, true, stable));
        }
        if (!left.isEmpty()) {
            charts.add(new ChartData("Fast vibration that is left in the cheapest run within 1 % of the swing",
                    STIFFNESS, "fast-mode energy, end / start", true, true, left));
        }
        return charts;
    }

    private static Series series(Sweep sweep, ToDoubleFunction<Cost> what) {
        return Series.of(name(sweep), Mark.LINE_AND_POINTS, sweep.costs(), Cost::stiffness, what);
    }

    private static String name(Sweep sweep) {
        return sweep.solver().label();
    }

    private static List<Series> failures(List<Sweep> sweeps, List<String> rows) {
        List<Series> series = new ArrayList<>();
        add(series, "never stable, however short the step", Mark.FAILURES, sweeps, rows, sweep -> cost ->
                sweep.neverStable());
        add(series, "no 1 % with a million steps", Mark.GIVEN_UP, sweeps, rows, sweep -> cost ->
                Double.isNaN(cost.toOnePercent()));
        return series;
    }

    private interface Which {
        Predicate<Cost> of(Sweep sweep);
    }

    private static void add(List<Series> series, String name, Mark mark, List<Sweep> sweeps, List<String> rows,
            Which which) {
        List<double[]> points = new ArrayList<>();
        sweeps.forEach(sweep -> sweep.costs().stream().filter(which.of(sweep))
                .forEach(cost -> points.add(new double[] {cost.stiffness(), rows.indexOf(name(sweep))})));
        if (!points.isEmpty()) {
            series.add(Series.of(name, mark, points, point -> point[0], point -> point[1]));
        }
    }

    /**
     * @param sweeps the sweep of each solver
     * @return a sentence about the growth of the cost of stability with the stiffness
     */
    public static String finding(List<Sweep> sweeps) {
        List<String> parts = new ArrayList<>();
        most(sweeps, sweep -> !sweep.solver().implicit()).ifPresent(power -> parts.add("as " + power + " (explicit)"));
        most(sweeps, sweep -> sweep.solver().implicit() && !unlimited(sweep))
                .ifPresent(power -> parts.add("as " + power + " (implicit)"));
        boolean unlimited = sweeps.stream().anyMatch(StiffCharts::unlimited);
        List<String> never = sweeps.stream().filter(Sweep::neverStable).map(StiffCharts::name).toList();
        String finding = (parts.isEmpty() ? "What a stiff spring costs"
                : "Evaluations for stability grow " + String.join(", ", parts))
                + (unlimited ? "; implicit solvers are stable at any step" : "");
        return never.isEmpty() ? finding
                : finding + "; " + String.join(", ", never) + (never.size() == 1 ? " is" : " are") + " never stable";
    }

    private static boolean unlimited(Sweep sweep) {
        return sweep.solver().info().map(info -> info.imaginaryLimit() == Double.POSITIVE_INFINITY).orElse(false);
    }

    /** The largest exponent of these sweeps, as a power of k. */
    private static Optional<String> most(List<Sweep> sweeps, Predicate<Sweep> which) {
        return sweeps.stream().filter(which).map(Sweep::stableExponent).filter(exponent -> !exponent.isNaN())
                .max(Comparator.naturalOrder()).map(exponent -> String.format(Locale.ROOT, "k^%.1f", exponent));
    }

    /**
     * @param sweeps the sweep of each solver
     * @return the exponents, and the cost for the stiffest spring
     */
    public static DataTable table(List<Sweep> sweeps) {
        return DataTable.of("stiffness", """
                Evaluations grow as k^exponent, where k is the stiffness: for stability, and for an error of 1 %. \
                Then, the evaluations for 1 % with the softest and the stiffest spring""", sweeps,
                column("solver", StiffCharts::name), column("stable", StiffCharts::stable),
                column("exponent, stability", 3, sweep -> unlimited(sweep) ? Double.NaN
                        : exponent(sweep.stableExponent())),
                column("exponent, 1 %", 3, sweep -> exponent(sweep.preciseExponent())),
                column("evaluations, softest", sweep -> sweep.costs().get(0).toOnePercent()),
                column("evaluations, stiffest", sweep -> sweep.costs().get(sweep.costs().size() - 1).toOnePercent()));
    }

    private static String stable(Sweep sweep) {
        return sweep.neverStable() ? "never: grows at any step"
                : sweep.solver().adaptive() ? "by step-size control"
                : unlimited(sweep) ? "at any step" : "below its limit";
    }

    /** Two decimals: those after that come from the numbers of steps being whole. */
    private static double exponent(double fitted) {
        return Double.isNaN(fitted) ? fitted : Math.round(100 * fitted) / 100.0;
    }
}
