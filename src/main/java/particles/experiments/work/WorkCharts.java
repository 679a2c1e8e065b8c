package particles.experiments.work;

import static particles.view.DataTable.column;

import deSolvers.text.Digits;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import particles.experiments.runs.SolverChoice;
import particles.experiments.work.WorkPrecision.Curve;
import particles.experiments.work.WorkPrecision.Failure;
import particles.experiments.work.WorkPrecision.Point;
import particles.view.ChartData;
import particles.view.ChartData.Mark;
import particles.view.ChartData.Series;
import particles.view.DataTable;

/**
 * A work-precision comparison as diagrams and tables. A diagram has the errors above and the runs without a result
 * below, each solver in a row of its own.
 */
public final class WorkCharts {
    private static final double ROUGH = 1e-2;
    private static final double FINE = 1e-6;
    /** Evaluations that differ by less than this factor are a tie, since those between two runs are interpolated. */
    private static final double READ = 1.05;

    private WorkCharts() {
    }

    /**
     * @param curves the curves of all solvers on one problem
     * @return error against evaluations, with fitted slopes in the legend; below, if there are any, the failures
     */
    public static List<ChartData> byEvaluations(List<Curve> curves) {
        List<Series> series = new ArrayList<>();
        for (Curve curve : curves) {
            List<Point> fitted = curve.points().subList(curve.fit().first(), curve.fit().last() + 1);
            series.add(Series.of(curve.label() + slope(curve), Mark.LINE_AND_OPEN_POINTS, curve.points(),
                    Point::evaluations, Point::error));
            series.add(Series.of(curve.label() + slope(curve), Mark.POINTS, fitted, Point::evaluations, Point::error));
            if (isReduced(curve)) {                     // the errors that the full order would give
                double order = curve.solver().order();
                Point first = fitted.get(0);
                series.add(Series.of(Digits.format("%s at order %.0f", curve.label(), order), Mark.LINE, fitted,
                        Point::evaluations, p -> first.error() * Math.pow(p.deltaT() / first.deltaT(), order)));
            }
        }
        series.add(Series.of("number: slope of the filled points (theory)", Mark.POINTS, List.of()));
        return charts(reduction(curves).orElseGet(() -> first(curves, false)), "evaluations of the derivative", series,
                curves, Point::evaluations);
    }

    /**
     * @param curves the curves of all solvers on one problem
     * @return error against CPU time, with bars from the fastest round to the median; below, if there are any, the
     *         failures
     */
    public static List<ChartData> byTime(List<Curve> curves) {
        List<Series> series = new ArrayList<>();
        for (Curve curve : curves) {
            series.add(Series.of(curve.label(), Mark.LINE_AND_POINTS, curve.points(), Point::fastest, Point::error));
            series.add(Series.of(curve.label(), Mark.BARS, curve.points().stream().flatMap(p -> Stream.of(
                    new double[] {p.fastest(), p.error()}, new double[] {p.median(), p.error()},
                    new double[] {Double.NaN, Double.NaN})).toList()));         // a gap after each bar
        }
        return charts(first(curves, true), "CPU time, fastest round (s)", series, curves, Point::fastest);
    }

    /** Below the errors, over the same work: a row for each solver of which a run failed. */
    private static List<ChartData> charts(String finding, String label, List<Series> series, List<Curve> curves,
            ToDoubleFunction<Point> work) {
        WorkProblem problem = curves.get(0).problem();
        ChartData errors = new ChartData(problem.title() + ": " + finding, label, problem.errorLabel(), true, true,
                series);
        List<Curve> failing = curves.stream().filter(curve -> curve.points().stream().anyMatch(point ->
                point.failure().isPresent())).toList();
        return errors.above("no result", failing.stream().map(Curve::label).toList(), Arrays.stream(Failure.values())
                .map(kind -> Series.of(kind.words, kind == Failure.UNSTABLE ? Mark.FAILURES : Mark.GIVEN_UP,
                        failing.stream().flatMap(curve -> curve.failures(kind).map(point -> new double[] {
                            work.applyAsDouble(point), failing.indexOf(curve)})).toList())).toList());
    }

    /** @return the fitted slope and the theoretical one, as text for the legend */
    static String slope(Curve curve) {
        return Double.isNaN(curve.fit().slope()) ? "" : Digits.format(", %.2f", curve.fit().slope())
                + (Double.isNaN(curve.expected()) ? "" : Digits.format(" (%.0f)", curve.expected()));
    }

    /** Whether theory predicts order reduction and there is a slope to show it. */
    private static boolean isReduced(Curve curve) {
        return curve.expected() < curve.solver().order() && !Double.isNaN(curve.fit().slope());
    }

    private static Optional<String> reduction(List<Curve> curves) {
        return curves.stream().filter(WorkCharts::isReduced).findFirst().map(curve -> Digits.format(
                "%s falls from order %.0f to %.2f (theory: %.0f)", curve.label(), curve.solver().order(),
                curve.fit().slope(), curve.expected()));
    }

    /** Which solver gets to a rough and to a fine error first; all of them where several cannot be told apart. */
    private static String first(List<Curve> curves, boolean time) {
        double largest = curves.stream().flatMap(curve -> curve.points().stream()).mapToDouble(Point::error)
                .filter(error -> error > 0).max().orElse(Double.POSITIVE_INFINITY);
        if (largest <= FINE) {
            return "every stable run has an error below " + Digits.exact(Digits.roundStep(largest))
                    + (curves.size() == 1 ? "" : "; " + SolverChoice.said(first(curves, largest, time), "is stable "
                    + (time ? "in the least time" : "with the fewest evaluations")));
        }
        String text = "";
        String before = "";
        for (double error : largest > ROUGH ? List.of(ROUGH, FINE) : List.of(FINE)) {
            List<String> solvers = first(curves, error, time);
            String who = solvers.isEmpty() ? "no run reaches" : SolverChoice.few(solvers)
                    + (solvers.size() > 1 ? " tie for" : curves.size() == 1 ? " reaches"
                    : time ? " is first to" : " is cheapest for");
            text += (text.isEmpty() ? who + " an error of " : who.equals(before) ? " and " : ", " + who + " ")
                    + Digits.few(error);
            before = who;
            if (solvers.isEmpty()) {
                break;
            }
        }
        return text;
    }

    /** The least work at which the line through a solver's points is at or below an error; a tie goes up to most. */
    private record Crossing(String solver, double least, double most) {
    }

    /**
     * @param time whether work is CPU time, in which solvers tie up to the median, or evaluations
     * @return the solver with the least work for an error, then every other one that cannot be told from it
     */
    static List<String> first(List<Curve> curves, double error, boolean time) {
        List<Crossing> all = curves.stream().flatMap(curve -> (time
                ? crossings(curve, error, Point::fastest, Point::median)
                : crossings(curve, error, Point::evaluations, point -> READ * point.evaluations()))
                .min(Comparator.comparingDouble(Crossing::least)).stream())
                .sorted(Comparator.comparingDouble(Crossing::least)).toList();
        return all.stream().filter(one -> one.least() <= all.get(0).most()).map(Crossing::solver).toList();
    }

    /** The runs with small enough errors, and the points where lines between runs cross the error. */
    private static Stream<Crossing> crossings(Curve curve, double error, ToDoubleFunction<Point> least,
            ToDoubleFunction<Point> most) {
        return IntStream.range(0, curve.points().size()).boxed().flatMap(k -> {
            Point from = curve.points().get(Math.max(0, k - 1));
            Point to = curve.points().get(k);
            double crossed = Math.log(from.error() / error) / Math.log(from.error() / to.error());
            return Stream.of(crossed, to.error() <= error ? 1 : Double.NaN).filter(part -> part > 0 && part <= 1)
                    .map(part -> new Crossing(curve.label(), between(from, to, part, least),
                            between(from, to, part, most)));
        });
    }

    /** On a straight line between two points, on logarithmic axes. */
    private static double between(Point from, Point to, double part, ToDoubleFunction<Point> work) {
        return Math.pow(work.applyAsDouble(from), 1 - part) * Math.pow(work.applyAsDouble(to), part);
    }

    /**
     * @param curves the curves on all problems
     * @return the fitted slopes, the theoretical ones, and the runs that were fitted
     */
    public static DataTable slopes(List<Curve> curves) {
        return DataTable.of("slopes",
                "Fitted slopes beside theory; a fit is of the runs from the coarsest to the finest fitted", curves,
                column("problem", curve -> curve.problem().name()), column("solver", Curve::label),
                column("slope", 3, curve -> curve.fit().slope()), column("theory", Curve::expected),
                column("order", curve -> curve.solver().order()),
                column("varied", curve -> curve.byStep() ? "deltaT (s)" : "tolerance"),
                column("coarsest fitted", 3, curve -> varied(curve, curve.fit().first())),
                column("finest fitted", 3, curve -> varied(curve, curve.fit().last())),
                column("fitted", curve -> curve.fit().last() - curve.fit().first() + 1),
                column("runs", curve -> curve.points().size()),
                column("unstable", curve -> curve.failures(Failure.UNSTABLE).count()),
                column("not converged", curve -> curve.failures(Failure.NOT_CONVERGED).count()),
                column("why no slope", curve -> curve.fit().whyNot()));
    }

    /** What was varied from run to run, deltaT (s) or the tolerance; NaN where there is no fit. */
    private static double varied(Curve curve, int run) {
        return Double.isNaN(curve.fit().slope()) ? Double.NaN : curve.byStep() ? curve.points().get(run).deltaT()
                : curve.points().get(run).tolerance();
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
                column("fitted", row -> row.curve.fit().contains(row.k) ? "yes" : ""),
                column("fastest round (s)", 2, row -> row.point.fastest()),
                column("median (s)", 2, row -> row.point.median()),
                column("no result", row -> row.point.failure().map(kind -> kind.words).orElse("")),
                column("why", row -> row.point.why()));
    }
}
