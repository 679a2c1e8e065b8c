package benchmarks;

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
     * @param plans   the comparisons
     * @param found   their settings, in the same order
     * @param medians the time of each run (ns)
     */
    static DataTable comparison(List<Comparison.Plan> plans, List<Comparison> found, Map<Run, Double> medians) {
        List<List<Object>> rows = new ArrayList<>();
        for (int k = 0; k < found.size(); k++) {
            Comparison.Plan plan = plans.get(k);
            Comparison pair = found.get(k);
            double ours = medians.get(pair.ours());
            double theirs = medians.get(pair.theirs());
            rows.add(List.of(plan.atEqual(), plan.workload(), plan.ours(), plan.theirs(),
                    pair.oursFound().evaluations(),
                    pair.theirsFound().evaluations(), pair.oursFound().error(), pair.theirsFound().error(),
                    ours / MICRO,
                    theirs / MICRO, theirs / ours));
        }
        return new DataTable(COMPARISON,
                "Beside Hipparchus: the same source, once the same steps, and once the same error",
                List.of(DataTable.column("equal"), DataTable.column("workload"), DataTable.column("ours"),
                        DataTable.column("Hipparchus"), DataTable.column("evaluations"),
                        DataTable.column("its evaluations"),
                        new DataTable.Column("error", 2), new DataTable.Column("its error", 2),
                        new DataTable.Column("time (\u00b5s)", 3), new DataTable.Column("its time (\u00b5s)", 3),
                        new DataTable.Column("its time over ours", 2)), rows);
    }

    /**
     * @param runs    of our solvers, by steps
     * @param medians the time of each (ns)
     */
    static DataTable solvers(List<Run> runs, Map<Run, Double> medians) {
        List<List<Object>> rows = new ArrayList<>();
        for (Run run : runs) {
            Workload workload = Workload.of(run.workload());
            long evaluations = run.outcome(workload, workload.reference(run.duration())).evaluations();
            double step = medians.get(run) / run.steps();
            rows.add(List.of(run.workload(), run.method(), (double) evaluations / run.steps(), step / MICRO,
                    medians.get(run) / evaluations));
        }
        return new DataTable("solvers", "One step of each solver; adaptive ones with their own tolerances",
                List.of(DataTable.column("workload"), DataTable.column("solver"),
                new DataTable.Column("evaluations per step", 3),
                        new DataTable.Column("time a step (\u00b5s)", 3),
                        new DataTable.Column("time an evaluation (ns)",
                                3)), rows);
    }

    /** @param medians the time of each run and of the same one by hand (ns) */
    static DataTable steps(Map<Run, Double> medians) {
        List<List<Object>> rows = new ArrayList<>();
        medians.forEach((run, time) -> {
            if (medians.containsKey(ByHand.like(run))) {
                double byHand = medians.get(ByHand.like(run));
                rows.add(List.of(run.workload(), run.method(), time / run.steps() / MICRO,
                        byHand / run.steps() / MICRO, time / byHand));
            }
        });
        return new DataTable(STEPS, "A step of ours beside plain loops written by hand for the workload",
                List.of(DataTable.column("workload"), DataTable.column("solver"),
                        new DataTable.Column("ours (\u00b5s)", 3), new DataTable.Column("by hand (\u00b5s)", 3),
                        new DataTable.Column("ours over by hand", 3)), rows);
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
