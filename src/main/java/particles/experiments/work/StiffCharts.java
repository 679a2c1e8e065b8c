package particles.experiments.work;

import static particles.view.DataTable.column;

import deSolvers.text.Digits;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Predicate;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
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
        charts.add(new ChartData(drawn -> growth("Evaluations for 1 %", in(drawn, sweeps), Sweep::preciseExponent),
                STIFFNESS, "evaluations for 1 %", true, true, precise));
        List<String> rows = sweeps.stream().filter(sweep -> sweep.neverStable()
                || sweep.costs().stream().anyMatch(cost ->
                        Double.isNaN(cost.toOnePercent()))).map(StiffCharts::name).toList();
        if (!rows.isEmpty()) {
            charts.add(new ChartData("", STIFFNESS, "never", true, false, failures(sweeps, rows)).inRows(rows));
        }
        if (!stable.isEmpty()) {
            charts.add(new ChartData(drawn -> growth("Evaluations for stability", in(drawn, sweeps),
                    Sweep::stableExponent), STIFFNESS, "evaluations to be stable", true, true, stable));
        }
        if (!left.isEmpty()) {
            charts.add(new ChartData(StiffCharts::vibration, STIFFNESS, "fast-mode energy, end / start", true, true,
                    left));
        }
        return charts;
    }

    private static List<Sweep> in(List<Series> drawn, List<Sweep> sweeps) {
        return sweeps.stream().filter(sweep -> sweep.solver().isIn(drawn)).toList();
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
     * @return a sentence about the growth of the cost with the stiffness, and the solvers that are never stable
     */
    public static String finding(List<Sweep> sweeps) {
        List<String> never = sweeps.stream().filter(Sweep::neverStable).map(StiffCharts::name).toList();
        return growth("Evaluations for 1 %", sweeps, Sweep::preciseExponent) + (never.isEmpty() ? ""
                : "; " + SolverChoice.few(never) + (never.size() == 1 ? " is" : " are") + " never stable");
    }

    /** Solvers with equal exponents, to one decimal, share a place; the largest exponent comes first. */
    private static String growth(String what, List<Sweep> sweeps, ToDoubleFunction<Sweep> exponent) {
        Map<Double, List<String>> powers = new TreeMap<>(Comparator.reverseOrder());
        for (Sweep sweep : sweeps) {
            double power = exponent.applyAsDouble(sweep);
            if (!Double.isNaN(power)) {
                powers.computeIfAbsent(Math.round(10 * power) / 10.0, same -> new ArrayList<>()).add(name(sweep));
            }
        }
        List<String> flat = powers.getOrDefault(0.0, List.of());
        powers.remove(0.0);
        String growing = powers.entrySet().stream().map(power -> "k^" + Digits.few(power.getKey()) + " ("
                + SolverChoice.few(power.getValue()) + ")").collect(Collectors.joining(", "));
        return growing.isEmpty() ? flat.isEmpty() ? what : what + " stay the same at any stiffness with "
                + SolverChoice.few(flat)
                : what + " grow as " + growing + (flat.isEmpty() ? "" : ", not with " + SolverChoice.few(flat));
    }

    /** What becomes of the stiff vibration, by the last value of each solver and by the largest. */
    private static String vibration(List<Series> drawn) {
        Map<String, List<String>> fates = new LinkedHashMap<>();
        double most = 1;
        for (Series series : drawn) {
            double[] y = Arrays.stream(series.y()).filter(Double::isFinite).toArray();
            double largest = Arrays.stream(y).max().orElse(Double.NaN);
            double last = y.length == 0 ? Double.NaN : y[y.length - 1];
            most = Math.max(most, largest);
            fates.computeIfAbsent(largest > KEPT ? "is borrowed" : last >= 1 / KEPT ? "stays" : last <= LOST ? "is gone"
                    : "fades", fate -> new ArrayList<>()).add(series.name());
        }
        String borrowed = "up to " + Digits.few(new BigDecimal(most).round(new MathContext(1)).doubleValue())
                + " times is borrowed";
        return "The stiff vibration " + fates.entrySet().stream().map(fate -> fate.getKey().replace("is borrowed",
                borrowed) + " with " + SolverChoice.few(fate.getValue())).collect(Collectors.joining(", "));
    }

    private static boolean unlimited(Sweep sweep) {
        return sweep.solver().info().map(info -> info.imaginaryLimit() == Double.POSITIVE_INFINITY).orElse(false);
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
