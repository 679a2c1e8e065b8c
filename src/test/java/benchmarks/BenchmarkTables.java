package benchmarks;

import static particles.view.DataTable.column;

import java.util.ArrayList;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import particles.view.DataTable;

/** Tables of measured times. */
public final class BenchmarkTables {
    private static final double MICRO = 1e3;
    private static final String COMPARISON = "comparison";
    private static final String STEPS = "steps";

    private BenchmarkTables() {
    }

    /**
     * @param pairs   the comparisons
     * @param medians the time of each run (ns)
     */
    static DataTable comparison(List<Comparison> pairs, Map<Run, Double> medians) {
        return DataTable.of(COMPARISON,
                "Beside Hipparchus: the same source, once the same steps, and once the same error", pairs,
                column("equal", pair -> pair.plan().atEqual()), column("workload", pair -> pair.plan().workload()),
                column("ours", pair -> pair.plan().ours()), column("Hipparchus", pair -> pair.plan().theirs()),
                column("evaluations", pair -> pair.oursFound().evaluations()),
                column("its evaluations", pair -> pair.theirsFound().evaluations()),
                column("error", 2, pair -> pair.oursFound().error()),
                column("its error", 2, pair -> pair.theirsFound().error()),
                column("time (\u00b5s)", 3, pair -> medians.get(pair.ours()) / MICRO),
                column("its time (\u00b5s)", 3, pair -> medians.get(pair.theirs()) / MICRO),
                column("its time over ours", 2, pair -> medians.get(pair.theirs()) / medians.get(pair.ours())));
    }

    /**
     * @param runs    of our solvers, by steps
     * @param medians the time of each (ns)
     */
    static DataTable solvers(List<Run> runs, Map<Run, Double> medians) {
        return DataTable.of("solvers", "One step of each solver; adaptive ones with their own tolerances", runs,
                column("workload", Run::workload), column("solver", Run::method),
                column("evaluations per step", 3, run -> evaluations(run) / run.steps()),
                column("time a step (\u00b5s)", 3, run -> medians.get(run) / run.steps() / MICRO),
                column("time an evaluation (ns)", 3, run -> medians.get(run) / evaluations(run)));
    }

    private static double evaluations(Run run) {
        Workload workload = Workload.of(run.workload());
        return run.outcome(workload, workload.reference(run.duration())).evaluations();
    }

    /** @param medians the time of each run and of the same one by hand (ns) */
    static DataTable steps(Map<Run, Double> medians) {
        return DataTable.of(STEPS, "A step of ours beside plain loops written by hand for the workload",
                medians.keySet().stream().filter(run -> medians.containsKey(ByHand.like(run))).toList(),
                column("workload", Run::workload), column("solver", Run::method),
                column("ours (\u00b5s)", 3, run -> medians.get(run) / run.steps() / MICRO),
                column("by hand (\u00b5s)", 3, run -> medians.get(ByHand.like(run)) / run.steps() / MICRO),
                column("ours over by hand", 3, run -> medians.get(run) / medians.get(ByHand.like(run))));
    }

    private static String twoDigits(double ratio) {
        return String.format(Locale.ROOT, ratio < 9.95 ? "%.1f" : "%.0f", ratio);
    }

    /**
     * @param tables as measured
     * @return the finding, in a sentence
     */
    public static String finding(List<DataTable> tables) {
        List<String> parts = new ArrayList<>();
        for (String equal : List.of("evaluations", "error")) {
            range(tables, COMPARISON, row -> row.get(0).equals(equal)).ifPresent(range -> parts.add("Hipparchus takes "
                    + range + " times as long as ours at equal " + equal));
        }
        range(tables, STEPS, row -> true).ifPresent(range -> parts.add("a step of ours takes " + range
                + " times as long as loops by hand"));
        return parts.isEmpty() ? "What solvers, effects, scenes and frames take" : String.join(", and ", parts);
    }

    /** The range of a table's last column. */
    private static Optional<String> range(List<DataTable> tables, String name, Predicate<List<Object>> rows) {
        DoubleSummaryStatistics ratios = tables.stream().filter(table -> table.name().equals(name))
                .flatMap(table -> table.rows().stream()).filter(rows)
                .mapToDouble(row -> (Double) row.get(row.size() - 1)).summaryStatistics();
        return ratios.getCount() == 0 ? Optional.empty()
                : Optional.of(twoDigits(ratios.getMin()) + " to " + twoDigits(ratios.getMax()));
    }
}
