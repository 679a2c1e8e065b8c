package particles.experiments.phase;

import static particles.view.DataTable.column;

import deSolvers.text.Digits;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.IntStream;
import particles.experiments.runs.ProgressListener;
import particles.experiments.runs.SceneRun;
import particles.experiments.runs.SceneRun.Outcome;
import particles.experiments.runs.SceneRun.Setting;
import particles.experiments.runs.SolverChoice;
import particles.scene.format.SceneDescription;
import particles.view.Chart;
import particles.view.DataTable;
import particles.view.Look;
import particles.view.Series;
import particles.view.Series.Mark;

/**
 * Phase portraits of a scene: the path of a particle with each of several solvers, over that of a very accurate run,
 * one chart for each solver.
 */
public final class PhasePortraits {
    private static final double REFERENCE_TOLERANCE = 1e-10;
    private static final String REFERENCE = "reference";
    /**
     * A path that goes farther out than this many times the reference leaves the picture; otherwise all else would
     * shrink to a dot.
     */
    private static final double PICTURE = 3.2;

    /**
     * The result of the runs.
     *
     * @param portraits the portrait of each solver
     * @param table     the last state of the particle with each solver, and how far it is from the reference's
     */
    public record Portraits(List<Portrait> portraits, DataTable table) {
    }

    /** A run with the path of the particle. */
    private record Run(Setting setting, PhaseHistory path, Outcome outcome) {
    }

    private PhasePortraits() {
    }

    /**
     * @param scene     a scene, with the step and duration that are wanted
     * @param solvers   the solvers to compare
     * @param particle  the id of the particle
     * @param wanted    the axis of the portraits; empty for the one along which the particle goes farthest
     * @param about     the particle about which angles are measured, for {@link Coordinate#ANGLE}
     * @param progress  receives the progress
     * @return the portraits
     */
    public static Portraits compare(SceneDescription scene, List<SolverChoice> solvers, String particle,
            Optional<Coordinate> wanted, Optional<String> about, ProgressListener progress) {
        List<Setting> settings = new ArrayList<>(List.of(Setting.accurate(scene.deltaT(), REFERENCE_TOLERANCE)));
        solvers.forEach(solver -> settings.add(Setting.of(solver, scene.deltaT())));
        List<Run> runs = progress.onAllCores(settings, Setting::label, setting -> {
            PhaseHistory path = new PhaseHistory(particle, about, scene.duration() / scene.deltaT());
            return new Run(setting, path, SceneRun.run(SceneRun.build(scene, setting), List.of(path)));
        });
        Coordinate axis = wanted.orElseGet(runs.get(0).path()::widestAxis);
        Series exact = runs.get(0).path().path(axis, Look.REFERENCE, REFERENCE);
        List<Portrait> portraits = runs.subList(1, runs.size()).stream().map(run -> new Portrait(particle, axis,
                run.path().path(axis, run.setting().solver().look(), run.setting().label()), exact, run.outcome()))
                .toList();
        List<Portrait> rows = new ArrayList<>(portraits);
        rows.add(new Portrait(particle, axis, exact, exact, runs.get(0).outcome()));
        return new Portraits(portraits, DataTable.of("ends", "Where '" + particle + "' was at the end", rows,
                column("solver", Portrait::solver),
                column(axis.position("").label(), row -> last(row.path().x())),
                column(axis.velocity("").label(), row -> last(row.path().y())),
                column(axis.position(" error").label(), 3, row -> row.error(Series::x)),
                column(axis.velocity(" error").label(), 3, row -> row.error(Series::y)),
                column("evaluations", row -> row.outcome().evaluations()),
                column("what went wrong", row -> row.outcome().failure().orElse(""))).withoutEmptyColumns());
    }

    private static double last(double[] values) {
        return values[values.length - 1];
    }

    /**
     * One solver's path of one particle over that of a very accurate run.
     *
     * @param particle its id
     * @param axis    the axis
     * @param path    the path, with the solver's label for a name
     * @param exact   the reference's path
     * @param outcome the outcome of the solver's run
     */
    public record Portrait(String particle, Coordinate axis, Series path, Series exact, Outcome outcome) {
        /** @return the solver's label */
        public String solver() {
            return path.name();
        }

        /** @return whether the run reached its end */
        public boolean whole() {
            return outcome.whole();
        }

        /** @return how far the last value is from the reference's; NaN if the run did not reach its end */
        double error(Function<Series, double[]> which) {
            return whole() ? Math.abs(last(which.apply(path)) - last(which.apply(exact))) : Double.NaN;
        }

        /** @return the path over the reference, with both ends and the point where it leaves the picture */
        public Chart chart() {
            DoubleSummaryStatistics x = PhaseHistory.range(exact.x());
            DoubleSummaryStatistics v = PhaseHistory.range(exact.y());
            int shown = (int) IntStream.range(0, path.x().length).takeWhile(n ->
                    !outside(path.x()[n], x) && !outside(path.y()[n], v)).count();
            int end = shown - 1;
            int last = exact.x().length - 1;
            List<Series> series = new ArrayList<>(List.of(
                    new Series(exact.look(), exact.name(), exact.mark() == Mark.LINE ? Mark.BAND : exact.mark(),
                            exact.x(), exact.y()),
                    new Series(path.look(), solver(), path.mark(), Arrays.copyOf(path.x(), shown),
                            Arrays.copyOf(path.y(), shown)),
                    PhaseHistory.start(exact.x()[0], exact.y()[0]),
                    Series.point(Look.MARK, "reference end", Mark.OPEN_POINTS, exact.x()[last], exact.y()[last])));
            if (end >= 0) {
                boolean ends = whole() && shown == path.x().length;
                series.add(Series.point(Look.MARK, ends ? "end" : "stopped, or out of the picture",
                        ends ? Mark.POINTS : Mark.FAILURES, path.x()[end], path.y()[end]));
            }
            return new Chart(axis.position(" of '" + particle + "'"), axis.velocity(""), series);
        }

        private static boolean outside(double value, DoubleSummaryStatistics range) {
            double half = (range.getMax() - range.getMin()) / 2;
            return half > 0 && Math.abs(value - range.getMin() - half) > PICTURE * half;
        }

        /** @return the error of the last position, or the time of the failure, in a line */
        public String answer() {
            return whole() ? Digits.few(error(Series::x), 3) + " " + axis.position("").unit() + " off at the end"
                    : "stopped at " + Digits.few(outcome.endTime(), 3) + " s";
        }
    }
}
