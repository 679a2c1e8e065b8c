package particles.experiments.work;

import static particles.view.DataTable.column;

import deSolvers.text.Digits;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import java.util.function.ToDoubleFunction;
import particles.experiments.runs.SolverChoice;
import particles.experiments.work.StiffGallery.Cost;
import particles.experiments.work.StiffGallery.Sweep;
import particles.view.Axis;
import particles.view.Chart;
import particles.view.DataTable;
import particles.view.Series;
import particles.view.Series.Mark;

/** Charts and table of the stiff gallery. */
public final class StiffCharts {
    private static final Axis STIFFNESS = Axis.log("stiffness k", "N/m");
    /** Smaller values are drawn as this one: the vibration is gone. */
    private static final double GONE = 1e-16;
    private static final Axis LEFT = Axis.log("fast-mode energy, end / start (\u2265 " + Digits.few(GONE) + ")", "");

    private StiffCharts() {
    }

    /**
     * @param sweeps the sweep of each solver
     * @return charts over the stiffness: evaluations for an error of 1 %; solvers that are never stable or never reach
     *         1 %, if there are any; evaluations needed to be stable; the rest of the vibration for stable runs
     */
    public static List<Chart> charts(List<Sweep> sweeps) {
        List<Sweep> limited = sweeps.stream().filter(sweep -> sweep.neverStable() || sweep.costs().stream()
                .anyMatch(StiffCharts::isImprecise)).toList();
        List<Series> never = new ArrayList<>();
        for (Sweep sweep : limited) {
            never.add(never("never stable, however short the step", Mark.FAILURES, sweep, limited, cost ->
                    sweep.neverStable()));
            never.add(never("no 1 % with a million steps", Mark.GIVEN_UP, sweep, limited, StiffCharts::isImprecise));
        }
        List<Chart> charts = new ArrayList<>(chart("", Axis.log("evaluations for 1 % error of the swing", ""),
                sweeps, Cost::toOnePercent).above("never", limited.stream().map(StiffCharts::name).toList(), never));
        charts.add(chart("evaluations-to-be-stable", Axis.log("evaluations to be stable", ""),
                stable(sweeps, solver -> !solver.adaptive()), Cost::toBeStable));
        List<Series> left = stable(sweeps, solver -> !solver.adaptive() || solver.implicit()).stream().map(sweep ->
                line(sweep, cost -> Math.max(GONE, cost.vibrationLeft())).ending(LEFT)).toList();
        charts.add(new Chart(STIFFNESS, LEFT, left).named("fast-mode-energy-end"));
        charts.removeIf(chart -> chart.series().isEmpty());
        return charts;
    }

    private static boolean isImprecise(Cost cost) {
        return Double.isNaN(cost.toOnePercent());
    }

    /** At each curve is the exponent with which the evaluations grow. */
    private static Chart chart(String name, Axis axis, List<Sweep> sweeps, ToDoubleFunction<Cost> what) {
        return new Chart(STIFFNESS, axis, sweeps.stream().map(sweep -> line(sweep, what).ending(
                Double.isNaN(sweep.exponent(what)) ? "" : "k^" + Digits.few(exponent(sweep, what), 2))).toList())
                .named(name);
    }

    private static Series line(Sweep sweep, ToDoubleFunction<Cost> what) {
        return Series.of(sweep.solver().look(), name(sweep), Mark.LINE_AND_POINTS, sweep.costs(), Cost::stiffness,
                what);
    }

    private static List<Sweep> stable(List<Sweep> sweeps, Predicate<SolverChoice> which) {
        return sweeps.stream().filter(sweep -> !sweep.neverStable() && which.test(sweep.solver())).toList();
    }

    private static String name(Sweep sweep) {
        return sweep.solver().label();
    }

    private static Series never(String name, Mark mark, Sweep sweep, List<Sweep> rows, Predicate<Cost> which) {
        return Series.of(sweep.solver().look(), name, mark, sweep.costs().stream().filter(which).toList(),
                Cost::stiffness, cost -> rows.indexOf(sweep));
    }

    private static boolean unlimited(Sweep sweep) {
        return sweep.solver().info().filter(info -> info.imaginaryLimit() == Double.POSITIVE_INFINITY).isPresent();
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
                        : exponent(sweep, Cost::toBeStable)),
                column("exponent, 1 %", 3, sweep -> exponent(sweep, Cost::toOnePercent)),
                column("evaluations, softest", sweep -> sweep.costs().get(0).toOnePercent()),
                column("evaluations, stiffest", sweep -> sweep.costs().get(sweep.costs().size() - 1).toOnePercent()));
    }

    private static String stable(Sweep sweep) {
        return sweep.neverStable() ? "never: grows at any step"
                : sweep.solver().adaptive() ? "by step-size control"
                : unlimited(sweep) ? "at any step" : "below its limit";
    }

    /** Two decimals: those after that come from the numbers of steps being whole. */
    private static double exponent(Sweep sweep, ToDoubleFunction<Cost> evaluations) {
        double fitted = sweep.exponent(evaluations);
        return Double.isNaN(fitted) ? fitted : Math.round(100 * fitted) / 100.0;
    }
}
