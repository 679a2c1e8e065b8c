package particles.experiments.work;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import particles.experiments.runs.SolverChoice;
import particles.experiments.work.WorkPrecision.Curve;
import particles.experiments.work.WorkPrecision.Failure;
import particles.experiments.work.WorkPrecision.Point;
import particles.view.ChartData;
import particles.view.ChartData.Mark;
import particles.view.ChartData.Series;

/** Work-precision diagrams: the errors above, the runs without a result below, each solver in a row of its own. */
public final class WorkCharts {
    private static final double ROUGH = 1e-2;
    private static final double FINE = 1e-6;
    /** Evaluations at a crossing between two runs are known to this part. */
    private static final double READ = 0.025;

    private WorkCharts() {
    }

    /**
     * @param problem the problem
     * @param curves  the curves of all solvers
     * @return error against evaluations, with fitted slopes in the legend; below, if there are any, the failures
     */
    public static List<ChartData> byEvaluations(WorkProblem problem, List<Curve> curves) {
        List<Series> series = new ArrayList<>();
        for (Curve curve : curves) {
            String name = curve.solver().label() + slope(curve);
            List<Point> open = new ArrayList<>();
            List<Point> fitted = new ArrayList<>();
            for (int k = 0; k < curve.points().size(); k++) {
                if (isResult(curve.points().get(k))) {
                    open.add(curve.points().get(k));
                    if (curve.fit().contains(k)) {
                        fitted.add(curve.points().get(k));
                    }
                }
            }
            series.add(Series.of(name, Mark.LINE_AND_OPEN_POINTS, open, Point::evaluations, Point::error));
            series.add(Series.of(name, Mark.POINTS, fitted, Point::evaluations, Point::error));
            unreduced(curve, fitted).ifPresent(series::add);
        }
        series.add(new Series("filled: fitted; in brackets: theory", Mark.POINTS, new double[0], new double[0]));
        return charts(new ChartData(drawn -> problem.title() + ": " + reduction(in(drawn, curves)).orElseGet(() ->
                first(in(drawn, curves), false)), "evaluations of the derivative", problem.errorLabel(), true, true,
                series), curves, Point::evaluations);
    }

    /**
     * @param problem the problem
     * @param curves  the curves of all solvers
     * @return error against CPU time, with bars from the lower to the upper quartile; below, if there are any, the
     * failures
     */
    public static List<ChartData> byTime(WorkProblem problem, List<Curve> curves) {
        List<Series> series = new ArrayList<>();
        for (Curve curve : curves) {
            List<Point> good = curve.points().stream().filter(WorkCharts::isResult).toList();
            series.add(Series.of(curve.solver().label(), Mark.LINE_AND_POINTS, good, Point::seconds, Point::error));
            double[] x = new double[3 * good.size()];
            double[] y = new double[3 * good.size()];
            for (int k = 0; k < good.size(); k++) {             // a gap after each bar
                x[3 * k] = good.get(k).lower();
                x[3 * k + 1] = good.get(k).upper();
                x[3 * k + 2] = Double.NaN;
                y[3 * k] = y[3 * k + 1] = good.get(k).error();
                y[3 * k + 2] = Double.NaN;
            }
            series.add(new Series(curve.solver().label(), Mark.BARS, x, y));
        }
        return charts(new ChartData(drawn -> problem.title() + ": " + first(in(drawn, curves), true),
                "CPU time, median (s)", problem.errorLabel(), true, true, series), curves, Point::seconds);
    }

    private static List<Curve> in(List<Series> drawn, List<Curve> curves) {
        return curves.stream().filter(curve -> curve.solver().isIn(drawn)).toList();
    }

    private static boolean isResult(Point point) {
        return point.failure().isEmpty() && point.error() > 0;
    }

    /** Below the errors, over the same work: a row for each solver of which a run failed. */
    private static List<ChartData> charts(ChartData errors, List<Curve> curves, ToDoubleFunction<Point> work) {
        List<String> rows = new ArrayList<>();
        List<List<double[]>> failures = List.of(new ArrayList<>(), new ArrayList<>());
        for (Curve curve : curves) {
            for (Point point : curve.points()) {
                point.failure().ifPresent(kind -> {
                    if (!rows.contains(curve.solver().label())) {
                        rows.add(curve.solver().label());
                    }
                    failures.get(kind.ordinal()).add(new double[] {work.applyAsDouble(point), rows.size() - 1});
                });
            }
        }
        if (rows.isEmpty()) {
            return List.of(errors);
        }
        List<Series> series = new ArrayList<>();
        for (Failure kind : Failure.values()) {
            List<double[]> of = failures.get(kind.ordinal());
            if (!of.isEmpty()) {
                boolean unstable = kind == Failure.UNSTABLE;
                series.add(Series.of(unstable ? "unstable" : "did not converge",
                        unstable ? Mark.FAILURES : Mark.GIVEN_UP, of, f -> f[0], f -> f[1]));
            }
        }
        return List.of(errors, new ChartData("", errors.xLabel(), "no result", true, false, series).inRows(rows));
    }

    /** @return the fitted slope and the theoretical one, as text for the legend */
    static String slope(Curve curve) {
        String theory = Double.isNaN(curve.expected()) ? "" : String.format(Locale.ROOT, " (%.0f)", curve.expected());
        return Double.isNaN(curve.fit().slope()) ? "" : String.format(Locale.ROOT, ", %.2f",
                curve.fit().slope())
                + theory;
    }

    /** For a reduced order: the errors that the full order would give, from the first fitted one on. */
    private static Optional<Series> unreduced(Curve curve, List<Point> fitted) {
        if (!(curve.expected() < curve.solver().order()) || fitted.isEmpty()) {
            return Optional.empty();
        }
        double first = fitted.get(0).error();
        double[] y = fitted.stream().mapToDouble(p -> first * Math.pow(p.deltaT() / fitted.get(0).deltaT(),
                curve.solver().order()))
                .toArray();
        return Optional.of(new Series(String.format(Locale.ROOT, "%s at order %.0f", curve.solver().label(),
                curve.solver().order()), Mark.LINE,
                fitted.stream().mapToDouble(Point::evaluations).toArray(), y));
    }

    /** The order predicted by theory for solvers with order reduction, if one of them has a slope. */
    private static Optional<String> reduction(List<Curve> curves) {
        return curves.stream().filter(curve -> curve.expected() < curve.solver().order()
                && !Double.isNaN(curve.fit().slope()))
                .findFirst().map(curve -> String.format(Locale.ROOT, "%s falls from order %.0f to %.2f (theory: %.0f)",
                        curve.solver().label(), curve.solver().order(), curve.fit().slope(), curve.expected()));
    }

    /** Which solver gets to a rough and to a fine error first; all of them where several cannot be told apart. */
    private static String first(List<Curve> curves, boolean time) {
        List<String> rough = first(curves, ROUGH, time);
        List<String> fine = first(curves, FINE, time);
        if (rough.isEmpty()) {
            return "none has an error of 0.01";
        }
        if (curves.size() == 1) {
            return rough.get(0) + " has 0.01" + (fine.isEmpty() ? ", not 1e-6" : " and 1e-6");
        }
        return said(rough, time) + " 0.01" + (fine.isEmpty() ? ", none has 1e-6" : rough.equals(fine) ? " and 1e-6"
                : ", " + said(fine, time) + " 1e-6");
    }

    private static String said(List<String> solvers, boolean time) {
        return SolverChoice.few(solvers) + (solvers.size() > 1 ? " tie for" : time ? " is first to"
                : " is cheapest for");
    }

    /** The work at which the line through a solver's points comes down to an error. */
    private record Crossing(String solver, double lower, double middle, double upper) {
    }

    /**
     * @param time whether work is CPU time, whose quartiles tell which solvers tie, or evaluations
     * @return the solver with the least work for an error, then every other one that cannot be told from it
     */
    static List<String> first(List<Curve> curves, double error, boolean time) {
        List<Crossing> all = curves.stream().flatMap(curve -> crossing(curve, error, time).stream())
                .sorted(Comparator.comparingDouble(Crossing::middle)).toList();
        return all.stream().filter(one -> one.lower() <= all.get(0).upper()).map(Crossing::solver).toList();
    }

    private static Optional<Crossing> crossing(Curve curve, double error, boolean time) {
        List<Point> points = curve.points().stream().filter(WorkCharts::isResult).toList();
        List<Crossing> found = new ArrayList<>();
        for (int k = 0; k < points.size(); k++) {
            Point from = points.get(Math.max(0, k - 1));
            Point to = points.get(k);
            if (to.error() <= error && (k == 0 || from.error() > error)) {
                double part = k == 0 ? 1 : Math.log(from.error() / error)
                        / Math.log(from.error() / to.error());
                double evaluations = between(from, to, part, Point::evaluations);
                found.add(time ? new Crossing(curve.solver().label(), between(from, to, part, Point::lower),
                        between(from, to, part, Point::seconds), between(from, to, part, Point::upper))
                        : new Crossing(curve.solver().label(), evaluations * (1 - READ), evaluations,
                        evaluations * (1 + READ)));
            }
        }
        return found.stream().min(Comparator.comparingDouble(Crossing::middle));
    }

    /** On a straight line between two points, on logarithmic axes. */
    private static double between(Point from, Point to, double part, ToDoubleFunction<Point> work) {
        return Math.pow(work.applyAsDouble(from), 1 - part) * Math.pow(work.applyAsDouble(to), part);
    }
}
