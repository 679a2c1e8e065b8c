package particles.experiments.energy;

import static particles.view.DataTable.column;

import deSolvers.text.Digits;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.LongSummaryStatistics;
import java.util.Map;
import java.util.stream.Collectors;
import particles.experiments.energy.EnergyDrift.Comparison;
import particles.experiments.energy.EnergyDrift.Drift;
import particles.experiments.energy.EnergyDrift.Kind;
import particles.experiments.runs.SolverChoice;
import particles.view.ChartData;
import particles.view.ChartData.Mark;
import particles.view.ChartData.Series;
import particles.view.DataTable;

/** The energy drift of several solvers, drawn, listed and told: each one's energy error, the worst first. */
public final class DriftCharts {
    /** The name of the crosses in a race's legend. */
    public static final String LEFT = "left the race";
    /** The linear chart ends at this part of the energy scale. */
    private static final double LINEAR = 0.1;
    private static final double SMALLEST = 1e-17;

    /** The largest number of solvers named; the others, which are better, are summed up in the last place. */
    private static final int NAMED = 4;
    /** Evaluations that differ by more than this factor are not equal. */
    private static final double EQUAL = 1.1;
    /** From ten times the energy on, a percentage is hard to read. */
    private static final double MANY_TIMES = 10;
    /** Failures come first, by the time that they reached, then the others by the size of their error. */
    private static final Comparator<Drift> WORST_FIRST = Comparator
            .comparing((Drift drift) -> drift.kind() != Kind.FAILED)
            .thenComparingDouble(drift -> drift.kind() == Kind.FAILED ? drift.outcome().endTime() : -size(drift));

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
            logarithmic.add(Series.of(comparison.race() ? LEFT : "stopped", Mark.FAILURES, failures));
        }
        return List.of(new ChartData(finding(comparison), "time (s)",
                        "|energy error| / scale", false, true, logarithmic),
                new ChartData(within(LINEAR, comparison), "time (s)",
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
                column("slope (1/s)", 3, Drift::slope), column("error over time", drift -> drift.kind().words),
                column("evaluations", drift -> drift.outcome().evaluations()),
                column("CPU time (s)", 2, drift -> drift.outcome().seconds()),
                column("what went wrong", drift -> drift.outcome().failure().orElse(""))).withoutEmptyColumns();
    }

    /**
     * @param comparison the measured drifts
     * @return a sentence that names each error with its size, the worst first
     */
    public static String finding(Comparison comparison) {
        return start(comparison) + parts(comparison) + end(comparison);
    }

    /** Of a chart that ends at a part of the energy scale: the solvers that leave it, then the others. */
    private static String within(double limit, Comparison comparison) {
        List<String> far = comparison.drifts().stream().filter(drift -> drift.largest() > limit)
                .map(Drift::label).toList();
        Comparison near = comparison.of(comparison.drifts().stream()
                .filter(drift -> drift.largest() <= limit).toList());
        return start(comparison) + (far.isEmpty() ? "" : SolverChoice.all(far, "exceeds " + part(limit)))
                + (far.isEmpty() || near.drifts().isEmpty() ? "" : "; ") + parts(near) + end(comparison);
    }

    private static String start(Comparison comparison) {
        boolean exchanges = comparison.drifts().stream().anyMatch(drift -> drift.kind() == Kind.EXCHANGING);
        return comparison.scene() + (exchanges ? ", numerical energy error: " : ": ");
    }

    private static String end(Comparison comparison) {
        LongSummaryStatistics made = comparison.drifts().stream().filter(drift -> drift.kind() != Kind.FAILED)
                .mapToLong(drift -> drift.outcome().evaluations()).summaryStatistics();
        return !comparison.equalWork() || made.getCount() == 0 ? "" : made.getMax() <= EQUAL * made.getMin()
                ? " (equal evaluations)" : " (" + made.getMin() + " to " + made.getMax() + " evaluations)";
    }

    private static String parts(Comparison comparison) {
        // equal verdicts share a place
        Map<String, List<Drift>> verdicts = comparison.drifts().stream().sorted(WORST_FIRST).collect(
                Collectors.groupingBy(drift -> verdict(drift, comparison.race()), LinkedHashMap::new,
                        Collectors.toList()));
        int places = verdicts.size() <= NAMED + 1 ? verdicts.size() : NAMED;
        List<Drift> others = verdicts.values().stream().skip(places).flatMap(List::stream).toList();
        List<Drift> whole = others.stream().filter(drift -> drift.kind() != Kind.FAILED).toList();
        int ended = others.size() - whole.size();
        return verdicts.entrySet().stream().limit(places).map(place -> SolverChoice.all(place.getValue()
                .stream().map(Drift::label).toList(), place.getKey())).collect(Collectors.joining("; "))
                + (ended == 0 ? "" : "; " + ended + " more " + SolverChoice.verb(ended, comparison.race()
                ? "leaves the race" : "stops early"))
                + (whole.isEmpty() ? "" : whole.size() == 1 ? "; " + whole.get(0).label() + " "
                + verdict(whole.get(0), comparison.race()) : "; the other " + whole.size() + " are off by at most "
                + part(whole.stream().mapToDouble(DriftCharts::size).max().orElse(0)));
    }

    /** A drift is measured at its end, an oscillation by its largest amplitude. */
    private static double size(Drift drift) {
        return drift.kind() == Kind.SECULAR ? Math.abs(drift.end()) : drift.largest();
    }

    /** @return what becomes of the energy, such as {@code gains 15 %}, or of the run */
    public static String verdict(Drift drift, boolean race) {
        return switch (drift.kind()) {
            case FAILED -> (race ? "leaves the race" : drift.largest() > MANY_TIMES ? "blows up" : "stops")
                    + " at t = " + Digits.few(drift.outcome().endTime()) + " s";
            case SECULAR -> (drift.end() > 0 ? "gains " : "loses ") + part(size(drift));
            case BOUNDED -> "stays within " + part(size(drift));
            case ROUNDING -> "is exact to round-off";
            case EXCHANGING -> (drift.extreme() > 0 ? "+" : drift.extreme() < 0 ? "\u2212" : "") + part(size(drift));
        };
    }

    /** A part of the energy scale, in percent. */
    private static String part(double of) {
        return of >= MANY_TIMES ? two(of) + " times the energy" : two(100 * of) + " %";
    }

    private static String two(double value) {
        return Double.isFinite(value) ? Digits.few(value, 2) : Double.toString(value);
    }
}
