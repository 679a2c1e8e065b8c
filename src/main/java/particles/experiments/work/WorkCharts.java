package particles.experiments.work;

import static particles.view.DataTable.column;

import deSolvers.text.Digits;
import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.experiments.work.WorkPrecision.Curve;
import particles.experiments.work.WorkPrecision.Failure;
import particles.experiments.work.WorkPrecision.Point;
import particles.view.Axis;
import particles.view.Chart;
import particles.view.DataTable;
import particles.view.Panel;
import particles.view.Series;
import particles.view.Series.Mark;

/**
 * A work-precision comparison as diagrams and tables. A diagram has the errors above and the runs without a result
 * below, each solver in a row of its own.
 */
public final class WorkCharts {
    private WorkCharts() {
    }

    /**
     * @param curves the curves of all solvers on one problem
     * @return error against evaluations, with fitted slopes at the curves; below, if there are any, the failures
     */
    public static Panel byEvaluations(List<Curve> curves) {
        List<Series> series = new ArrayList<>();
        for (Curve curve : curves) {
            List<Point> fitted = curve.fitted();
            series.add(Series.of(curve.look(), curve.label(), Mark.LINE_AND_OPEN_POINTS, curve.points(),
                    Point::evaluations, Point::error).ending(slope(curve)));
            series.add(Series.of(curve.look(), curve.label(), Mark.FITTED_POINTS, fitted, Point::evaluations,
                    Point::error));
            if (isReduced(curve)) {                     // the errors that the full order would give
                double order = curve.solver().order();
                Point first = fitted.get(0);
                series.add(Series.of(curve.look().variant(2), Digits.format("%s at order %.0f", curve.label(), order),
                        Mark.LINE, fitted, Point::evaluations,
                        p -> first.error() * Math.pow(p.deltaT() / first.deltaT(), order)));
            }
        }
        return panel("evaluations of the derivative", "", series, curves, Point::evaluations);
    }

    /**
     * @param curves the curves of all solvers on one problem
     * @return error against CPU time, with bars from the fastest round to the median; below, if there are any, the
     *         failures
     */
    public static Panel byTime(List<Curve> curves) {
        List<Series> series = new ArrayList<>();
        for (Curve curve : curves) {
            series.add(Series.of(curve.look(), curve.label(), Mark.LINE_AND_POINTS, curve.points(), Point::fastest,
                    Point::error).ending(curve.problem().errorAxis()));
            series.add(Series.of(curve.look(), curve.label(), Mark.BARS, curve.points().stream().flatMap(p -> Stream.of(
                    new double[] {p.fastest(), p.error()}, new double[] {p.median(), p.error()},
                    new double[] {Double.NaN, Double.NaN})).toList()));         // a gap after each bar
        }
        return panel("CPU time, fastest round", "s", series, curves, Point::fastest);
    }

    /** Below the errors, over the same work: a row for each solver of which a run failed. */
    private static Panel panel(String work, String unit, List<Series> series, List<Curve> curves,
            ToDoubleFunction<Point> size) {
        WorkProblem problem = curves.get(0).problem();
        List<Curve> failing = curves.stream().filter(curve -> curve.points().stream().anyMatch(point ->
                point.failure().isPresent())).toList();
        List<Series> failures = new ArrayList<>();
        for (Curve curve : failing) {
            for (Failure kind : Failure.values()) {
                failures.add(Series.of(curve.look(), kind.words, kind == Failure.UNSTABLE ? Mark.FAILURES
                        : Mark.GIVEN_UP, curve.failures(kind).toList(), size, point -> failing.indexOf(curve)));
            }
        }
        return Panel.of(problem.title() + ": error against " + work, new Chart(Axis.log(work, unit),
                problem.errorAxis(), series).above("no result", failing.stream().map(Curve::label).toList(), failures));
    }

    /** @return the fitted slope, and in brackets the theoretical one */
    static String slope(Curve curve) {
        return Double.isNaN(curve.fit().slope()) ? "" : Digits.format("%.2f", curve.fit().slope())
                + (Double.isNaN(curve.expected()) ? "" : Digits.format(" (%.0f)", curve.expected()));
    }

    /** Whether theory predicts order reduction and there is a slope to show it. */
    private static boolean isReduced(Curve curve) {
        return curve.expected() < curve.solver().order() && !Double.isNaN(curve.fit().slope());
    }

    /**
     * @param curves the curves on all problems
     * @return the fitted slopes, the theoretical ones, and the runs that were fitted
     */
    public static DataTable slopes(List<Curve> curves) {
        return DataTable.of("slopes",
                "Slopes beside theory, each over the three finest runs above round-off, if they are on a straight line",
                curves,
                column("problem", curve -> curve.problem().name()), column("solver", Curve::label),
                column("slope", 3, curve -> curve.fit().slope()), column("theory", Curve::expected),
                column("order", curve -> curve.solver().order()),
                column("varied", curve -> curve.byStep() ? "deltaT (s)" : "tolerance"),
                column("coarsest fitted", 3, curve -> varied(curve, 0)),
                column("finest fitted", 3, curve -> varied(curve, curve.fit().runs().size() - 1)),
                column("fitted", curve -> curve.fit().runs().size()),
                column("runs", curve -> curve.points().size()),
                column("unstable", curve -> curve.failures(Failure.UNSTABLE).count()),
                column("not converged", curve -> curve.failures(Failure.NOT_CONVERGED).count()),
                column("why no slope", curve -> curve.fit().whyNot()));
    }

    /** What was varied from run to run, deltaT (s) or the tolerance, in a run of the fit; NaN where there is none. */
    private static double varied(Curve curve, int run) {
        return curve.fitted().isEmpty() ? Double.NaN : curve.byStep() ? curve.fitted().get(run).deltaT()
                : curve.fitted().get(run).tolerance();
    }

    /**
     * @param curves the curves on all problems
     * @return every run
     */
    public static DataTable runs(List<Curve> curves) {
        record Row(Curve curve, int k, Point point) {
        }
        return DataTable.of("runs", "Every run; times of " + WorkPrecision.ROUNDS + " rounds",
                curves.stream().flatMap(curve -> IntStream.range(0, curve.points().size()).mapToObj(k ->
                        new Row(curve, k, curve.points().get(k)))).toList(),
                column("problem", row -> row.curve.problem().name()), column("solver", row -> row.curve.label()),
                column("deltaT (s)", row -> row.point.deltaT()), column("tolerance", 2, row -> row.point.tolerance()),
                column("evaluations", row -> row.point.evaluations()), column("error", 3, row -> row.point.error()),
                column("fitted", row -> row.curve.fit().runs().contains(row.k) ? "yes" : ""),
                column("fastest round (s)", 2, row -> row.point.fastest()),
                column("median (s)", 2, row -> row.point.median()),
                column("no result", row -> row.point.failure().map(kind -> kind.words).orElse("")),
                column("why", row -> row.point.why()));
    }
}
