package particles.experiments;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import particles.ChartData;
import particles.ChartData.Mark;
import particles.ChartData.Series;
import particles.DataTable;
import particles.experiments.SceneRun.Outcome;
import particles.experiments.SceneRun.Setting;
import particles.scene.Scene;
import particles.scene.SceneDescription;

/** Phase portraits of a scene: the paths that several solvers give a particle, over the path of a run as good as exact. */
public final class PhasePortraits {
    private static final double REFERENCE_TOLERANCE = 1e-10;
    private static final long MOST_EVALUATIONS = 20_000_000;
    private static final String REFERENCE = "reference (tolerance 1e-10)";

    /**
     * What came of the runs.
     *
     * @param charts one for each particle and axis: a path for each solver and the reference, and the ends of failed runs
     * @param table  where each solver's particle was at the end, and how far from the reference
     */
    public record Portraits(List<ChartData> charts, DataTable table) {
    }

    /** One solver's run, with the path of each particle. */
    private record Run(String name, List<PhaseHistory> paths, Outcome outcome) {
    }

    private PhasePortraits() {
    }

    /**
     * @param scene     a scene, with the step and duration that are wanted
     * @param solvers   whom to compare
     * @param particles their ids
     * @param axes      along which they are looked at
     * @param progress  hears how far it is
     * @return the portraits
     */
    public static Portraits compare(SceneDescription scene, List<SolverChoice> solvers, List<String> particles, List<Axis> axes,
                                    ProgressListener progress) {
        List<Run> runs = new ArrayList<>();
        for (SolverChoice solver : solvers) {
            progress.reached((double) runs.size() / (solvers.size() + 1), solver.label());
            runs.add(run(scene, new Setting(solver, scene.deltaT(), Optional.empty()), solver.label(), particles));
        }
        Setting tight = new Setting(SolverChoice.of("dormand-prince"), scene.deltaT(), Optional.of(REFERENCE_TOLERANCE));
        runs.add(run(scene, tight, REFERENCE, particles));
        List<ChartData> charts = new ArrayList<>();
        List<List<Object>> rows = new ArrayList<>();
        for (int p = 0; p < particles.size(); p++) {
            for (Axis axis : axes) {
                List<Series> paths = new ArrayList<>();
                for (Run run : runs) {
                    Series path = run.paths().get(p).chart(axis, "").series().get(0);
                    paths.add(new Series(run.name(), path.mark() == Mark.POINTS ? Mark.POINTS : Mark.LINE, path.x(), path.y()));
                }
                Series exact = paths.get(paths.size() - 1);
                for (int r = 0; r < runs.size(); r++) {
                    rows.add(row(particles.get(p), axis, runs.get(r), paths.get(r), exact));
                }
                charts.add(chart(scene.title() + ": '" + particles.get(p) + "', " + axis.symbol(), axis, runs, paths));
            }
        }
        return new Portraits(charts, new DataTable("ends", "Where the particle was at the end, and how far from the reference",
                List.of(DataTable.column("particle"), DataTable.column("axis"), DataTable.column("solver"),
                        DataTable.column("position (m)"), DataTable.column("velocity (m/s)"),
                        new DataTable.Column("position error (m)", 3), new DataTable.Column("velocity error (m/s)", 3),
                        DataTable.column("evaluations"), DataTable.column("why it ended")), rows));
    }

    private static Run run(SceneDescription scene, Setting setting, String name, List<String> particles) {
        List<PhaseHistory> paths = particles.stream().map(PhaseHistory::new).toList();
        Scene built = SceneRun.build(scene, setting, scene.duration());
        return new Run(name, paths, SceneRun.run(built, MOST_EVALUATIONS, paths));
    }

    private static List<Object> row(String particle, Axis axis, Run run, Series path, Series exact) {
        int end = path.x().length - 1;
        int last = exact.x().length - 1;
        boolean whole = run.outcome().failure().isEmpty();
        return List.of(particle, axis.symbol(), run.name(), path.x()[end], path.y()[end],
                whole ? Math.abs(path.x()[end] - exact.x()[last]) : Double.NaN,
                whole ? Math.abs(path.y()[end] - exact.y()[last]) : Double.NaN, run.outcome().evaluations(),
                run.outcome().failure().orElse(""));
    }

    private static ChartData chart(String title, Axis axis, List<Run> runs, List<Series> paths) {
        List<Series> series = new ArrayList<>();
        List<double[]> failed = new ArrayList<>();
        Series exact = paths.get(paths.size() - 1);
        double reach = 3 * Math.max(largest(exact.x()), largest(exact.y()));
        for (int r = 0; r < runs.size(); r++) {
            Series path = paths.get(r);
            int n = 0;
            while (n < path.x().length && Math.abs(path.x()[n]) <= reach && Math.abs(path.y()[n]) <= reach) {
                n++;
            }
            // what flies away leaves the picture, and would make everything else in it a dot
            series.add(new Series(path.name(), path.mark(), Arrays.copyOf(path.x(), n), Arrays.copyOf(path.y(), n)));
            if (n > 0 && (n < path.x().length || runs.get(r).outcome().failure().isPresent())) {
                failed.add(new double[] {path.x()[n - 1], path.y()[n - 1]});
            }
        }
        if (!failed.isEmpty()) {
            series.add(new Series("stopped, or out of the picture", Mark.FAILURES, failed.stream().mapToDouble(f -> f[0]).toArray(),
                    failed.stream().mapToDouble(f -> f[1]).toArray()));
        }
        return new ChartData(title, "position " + axis.symbol() + " (m)", "velocity v" + axis.symbol() + " (m/s)", false, false, series);
    }

    private static double largest(double[] values) {
        double largest = 0;
        for (double value : values) {
            largest = Math.max(largest, Math.abs(value));
        }
        return largest;
    }
}
