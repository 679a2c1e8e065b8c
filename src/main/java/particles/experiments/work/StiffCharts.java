package particles.experiments.work;

import static java.util.stream.Collectors.groupingBy;
import static java.util.stream.Collectors.joining;
import static java.util.stream.Collectors.mapping;
import static java.util.stream.Collectors.toList;
import static particles.view.DataTable.column;

import deSolvers.text.Digits;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.BiPredicate;
import java.util.function.Predicate;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;
import particles.experiments.runs.SolverChoice;
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
    /** Below this part a vibration is lost, and up to this factor it is kept. */
    private static final double LOST = 1e-9;
    private static final double KEPT = 2;

    private StiffCharts() {
    }

    /**
     * @param sweeps the sweep of each solver
     * @return charts over the stiffness: evaluations for an error of 1 %; solvers that are never stable or never reach
     *         1 %, if there are any; evaluations needed to be stable; the rest of the vibration for stable runs
     */
    public static List<ChartData> charts(List<Sweep> sweeps) {
        List<String> rows = sweeps.stream().filter(sweep -> sweep.neverStable() || sweep.costs().stream()
                .anyMatch(cost -> Double.isNaN(cost.toOnePercent()))).map(StiffCharts::name).toList();
        List<Sweep> fixed = stable(sweeps, solver -> !solver.adaptive());
        List<Series> left = series(stable(sweeps, solver -> !solver.adaptive() || solver.implicit()),
                cost -> Math.max(GONE, cost.vibrationLeft()));
        List<ChartData> first = chart("evaluations for 1 % error of the swing", sweeps, Cost::toOnePercent,
                growth("Evaluations for 1 % error of the swing", sweeps, Cost::toOnePercent))
                .above("never", rows, List.of(
                never("never stable, however short the step", Mark.FAILURES, sweeps, rows, (sweep, cost) ->
                        sweep.neverStable()),
                never("no 1 % with a million steps", Mark.GIVEN_UP, sweeps, rows, (sweep, cost) ->
                        Double.isNaN(cost.toOnePercent()))));
        return Stream.concat(first.stream(), Stream.of(
                chart("evaluations to be stable", fixed, Cost::toBeStable,
                        growth("Evaluations for stability", fixed, Cost::toBeStable)),
                new ChartData(vibration(left), STIFFNESS, "fast-mode energy, end / start (\u2265 "
                        + Digits.few(GONE) + ")", true, true, left)))
                .filter(chart -> !chart.series().isEmpty()).toList();
    }

    private static ChartData chart(String quantity, List<Sweep> sweeps, ToDoubleFunction<Cost> what,
            String finding) {
        return new ChartData(finding, STIFFNESS, quantity, true, true, series(sweeps, what));
    }

    private static List<Series> series(List<Sweep> sweeps, ToDoubleFunction<Cost> what) {
        return sweeps.stream().map(sweep ->
                Series.of(name(sweep), Mark.LINE_AND_POINTS, sweep.costs(), Cost::stiffness, what)).toList();
    }

    private static List<Sweep> stable(List<Sweep> sweeps, Predicate<SolverChoice> which) {
        return sweeps.stream().filter(sweep -> !sweep.neverStable() && which.test(sweep.solver())).toList();
    }

    private static String name(Sweep sweep) {
        return sweep.solver().label();
    }

    private static Series never(String name, Mark mark, List<Sweep> sweeps, List<String> rows,
            BiPredicate<Sweep, Cost> which) {
        return Series.of(name, mark, sweeps.stream().flatMap(sweep -> sweep.costs().stream()
                .filter(cost -> which.test(sweep, cost))
                .map(cost -> new double[] {cost.stiffness(), rows.indexOf(name(sweep))})).toList());
    }

    /**
     * @param sweeps the sweep of each solver
     * @return a sentence about the growth of the cost with the stiffness, and the solvers that are never stable
     */
    public static String finding(List<Sweep> sweeps) {
        List<String> never = sweeps.stream().filter(Sweep::neverStable).map(StiffCharts::name).toList();
        return growth("Evaluations for 1 % error of the swing", sweeps, Cost::toOnePercent)
                + (never.isEmpty() ? "" : "; " + SolverChoice.said(never, "is never stable"));
    }

    /** Solvers with equal exponents, to one decimal, share a place; the largest exponent comes first. */
    private static String growth(String what, List<Sweep> sweeps, ToDoubleFunction<Cost> evaluations) {
        Map<Double, List<String>> powers = sweeps.stream()
                .filter(sweep -> !Double.isNaN(sweep.exponent(evaluations)))
                .collect(groupingBy(sweep -> Math.round(10 * sweep.exponent(evaluations)) / 10.0,
                        () -> new TreeMap<Double, List<String>>(Comparator.reverseOrder()),
                        mapping(StiffCharts::name, toList())));
        String flat = Optional.ofNullable(powers.remove(0.0)).map(SolverChoice::few).orElse("");
        String growing = powers.entrySet().stream().map(power -> "k^" + Digits.few(power.getKey()) + " ("
                + SolverChoice.few(power.getValue()) + ")").collect(joining(", "));
        String from = " from k = " + Digits.few(StiffGallery.FIT_FROM) + " on ";
        return what + (growing.isEmpty() ? flat.isEmpty() ? "" : " stay about the same" + from + "with " + flat
                : " grow" + from + "as " + growing + (flat.isEmpty() ? "" : ", not with " + flat));
    }

    /** What becomes of the vibration, told by the last value of each solver that has one. */
    private static String vibration(List<Series> all) {
        List<Series> drawn = all.stream().filter(series -> Double.isFinite(stiffest(series))).toList();
        if (drawn.isEmpty()) {
            return "In the stiffest spring, none of these solvers reaches an error of 1 %";
        }
        String borrowed = Digits.format("reaches up to %.3g times its initial energy",
                drawn.stream().mapToDouble(StiffCharts::stiffest).max().orElse(0));
        return "In the stiffest spring, the vibration " + drawn.stream().collect(groupingBy(series ->
                stiffest(series) > KEPT ? borrowed : fate(stiffest(series)), LinkedHashMap::new,
                mapping(Series::name, toList()))).entrySet().stream()
                .map(fate -> fate.getKey() + " with " + SolverChoice.few(fate.getValue())).collect(joining(", "));
    }

    private static String fate(double left) {
        return left >= 1 / KEPT ? "stays" : left <= LOST ? "is gone" : "fades";
    }

    /** The last value; NaN if no run was accurate enough. */
    private static double stiffest(Series series) {
        return series.y()[series.y().length - 1];
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
