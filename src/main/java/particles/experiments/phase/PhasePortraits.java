package particles.experiments.phase;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.DoublePredicate;
import particles.experiments.runs.ProgressListener;
import particles.experiments.runs.SceneRun;
import particles.experiments.runs.SceneRun.Outcome;
import particles.experiments.runs.SceneRun.Setting;
import particles.experiments.runs.SolverChoice;
import particles.scene.Scene;
import particles.scene.format.SceneDescription;
import particles.view.ChartData;
import particles.view.ChartData.Mark;
import particles.view.ChartData.Series;
import particles.view.DataTable;

/**
 * Phase portraits of a scene: the path of a particle with each of several solvers, over that of a very accurate run,
 * one chart for each solver.
 */
public final class PhasePortraits {
    private static final double REFERENCE_TOLERANCE = 1e-10;
    private static final long MOST_EVALUATIONS = 20_000_000;
    private static final String REFERENCE = "reference";

    /**
     * One solver's path of one particle.
     *
     * @param solver   its label
     * @param particle the id of the particle
     * @param axis     the axis of the portrait
     * @param off      the largest distance of the path from the reference's curve, in halves of the curve's width and
     *                 height; NaN if the reference has no curve
     * @param whole    whether the run reached its end
     * @param chart    the path over the reference, both ends marked
     */
    public record Portrait(String solver, String particle, Axis axis, double off, boolean whole, ChartData chart) {
    }

    /**
     * The result of the runs.
     *
     * @param portraits the portraits of each particle, axis and solver
     * @param table     the last position of the particle with each solver, and its distance from the reference
     */
    public record Portraits(List<Portrait> portraits, DataTable table) {
    }

    /** One solver's run, with the path of each particle. */
    private record Run(String name, List<PhaseHistory> paths, Outcome outcome) {
    }

    private PhasePortraits() {
    }

    /**
     * @param scene     a scene, with the step and duration that are wanted
     * @param solvers   the solvers to compare
     * @param particles their ids
     * @param axes      the axes of the portraits; none for the one along which each particle goes farthest
     * @param about     the particle about which angles are measured, for {@link Axis#ANGLE}
     * @param progress  receives the progress
     * @return the portraits
     */
    public static Portraits compare(SceneDescription scene, List<SolverChoice> solvers, List<String> particles,
            List<Axis> axes, Optional<String> about, ProgressListener progress) {
        progress.reached(0, "the reference");
        Setting tight = new Setting(SolverChoice.ACCURATE, scene.deltaT(),
                Optional.of(REFERENCE_TOLERANCE));
        Run reference = run(scene, tight, REFERENCE, particles, about);
        List<Run> runs = new ArrayList<>();
        for (SolverChoice solver : solvers) {
            progress.reached((runs.size() + 1.0) / (solvers.size() + 1), solver.label());
            runs.add(run(scene, new Setting(solver, scene.deltaT(), Optional.empty()), solver.label(), particles,
                    about));
        }
        List<Portrait> portraits = new ArrayList<>();
        List<List<Object>> rows = new ArrayList<>();
        for (int p = 0; p < particles.size(); p++) {
            for (Axis axis : axes.isEmpty() ? List.of(reference.paths().get(p).widestAxis()) : axes) {
                Series exact = path(reference, p, axis);
                CurveDistance curve = new CurveDistance(exact.x(), exact.y());
                for (Run run : runs) {
                    Series path = path(run, p, axis);
                    boolean whole = run.outcome().failure().isEmpty();
                    PortraitChart chart = new PortraitChart(run.name(), path, exact, curve, whole);
                    portraits.add(new Portrait(run.name(), particles.get(p), axis, chart.getDistanceOff(), whole,
                            chart.data(particles.size() > 1 || axes.size() > 1 ? "'" + particles.get(p) + "', " : "",
                                    axis)));
                    rows.add(row(particles.get(p), axis, run, path, exact, chart.getDistanceOff()));
                }
                rows.add(row(particles.get(p), axis, reference, exact, exact, 0));
            }
        }
        boolean angles = axes.contains(Axis.ANGLE);
        String length = angles ? " (rad)" : " (m)";
        String speed = angles ? " (rad/s)" : " (m/s)";
        String position = angles ? "angle" : "position";
        String velocity = angles ? "angular velocity" : "velocity";
        return new Portraits(portraits, new DataTable("ends",
                "Where the particle was at the end, and how far its path was from the reference's curve on the way",
                List.of(DataTable.column("particle"), DataTable.column("axis"), DataTable.column("solver"),
                        DataTable.column(position + length), DataTable.column(velocity + speed),
                        new DataTable.Column(position + " error" + length, 3),
                        new DataTable.Column(velocity + " error" + speed, 3),
                        new DataTable.Column("off the curve (%)", 2), DataTable.column("evaluations"),
                        DataTable.column("why it ended")), rows));
    }

    /**
     * @param scene     its title
     * @param portraits the portraits of the scene
     * @return a sentence about the solvers that leave the curve of the reference and those that stay on it
     */
    public static String finding(String scene, List<Portrait> portraits) {
        Map<String, Double> worst = new LinkedHashMap<>();
        for (Portrait portrait : portraits) {
            if (!portrait.whole() || !Double.isNaN(portrait.off())) {
                worst.merge(portrait.solver(), portrait.whole() ? portrait.off() : Double.POSITIVE_INFINITY, Math::max);
            }
        }
        List<String> stopped = named(worst, off -> off == Double.POSITIVE_INFINITY);
        List<String> leaving = named(worst, off -> off > PortraitChart.LEFT && off < Double.POSITIVE_INFINITY);
        List<String> staying = named(worst, off -> off <= PortraitChart.LEFT);
        List<String> parts = new ArrayList<>();
        if (!stopped.isEmpty()) {
            parts.add(joined(stopped) + (stopped.size() == 1 ? " blows up" : " blow up"));
        }
        if (!leaving.isEmpty()) {
            parts.add(joined(leaving) + (leaving.size() == 1 ? " leaves the curve" : " leave the curve"));
        }
        if (!staying.isEmpty()) {
            double off = staying.stream().mapToDouble(worst::get).max().orElse(0);
            parts.add(joined(staying) + (staying.size() == 1 ? " stays" : " stay") + (leaving.isEmpty()
                    ? " on the curve to "
                    : " on it to ")
                    + PortraitChart.percent(off));
        }
        return scene + (parts.isEmpty() ? ", in state space" : ": " + String.join(", ", parts));
    }

    private static List<String> named(Map<String, Double> worst, DoublePredicate which) {
        return worst.keySet().stream().filter(solver -> which.test(worst.get(solver))).toList();
    }

    private static String joined(List<String> names) {
        return names.size() > 3 ? names.size() + " solvers" : SolverChoice.together(names);
    }

    private static Run run(SceneDescription scene, Setting setting, String name, List<String> particles,
            Optional<String> about) {
        List<PhaseHistory> paths = particles.stream().map(id -> new PhaseHistory(id, about)).toList();
        Scene built = SceneRun.build(scene, setting, scene.duration());
        return new Run(name, paths, SceneRun.run(built, MOST_EVALUATIONS, paths));
    }

    private static Series path(Run run, int particle, Axis axis) {
        Series path = run.paths().get(particle).chart(axis, "").series().get(0);
        return new Series(run.name(), path.mark() == Mark.POINTS ? Mark.POINTS : Mark.LINE, path.x(), path.y());
    }

    private static List<Object> row(String particle, Axis axis, Run run, Series path, Series exact, double off) {
        int end = path.x().length - 1;
        int last = exact.x().length - 1;
        boolean whole = run.outcome().failure().isEmpty();
        return List.of(particle, axis.symbol(), run.name(), path.x()[end], path.y()[end],
                whole ? Math.abs(path.x()[end] - exact.x()[last]) : Double.NaN,
                whole ? Math.abs(path.y()[end] - exact.y()[last]) : Double.NaN, 100 * off, run.outcome().evaluations(),
                run.outcome().failure().orElse(""));
    }
}
