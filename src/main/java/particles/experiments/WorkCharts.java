package particles.experiments;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import particles.ChartData;
import particles.ChartData.Mark;
import particles.ChartData.Series;
import particles.DataTable;
import particles.experiments.WorkPrecision.Curve;
import particles.experiments.WorkPrecision.Point;
import particles.experiments.problems.WorkProblem;

/** Work-precision diagrams and their tables. */
public final class WorkCharts {
    /** Where runs without a result are drawn: above all errors. */
    private static final double FAILED = 30;

    private WorkCharts() {
    }

    /**
     * @param problem what was solved
     * @param curves  by whom
     * @return error against evaluations, with fitted slopes in the legend
     */
    public static ChartData byEvaluations(WorkProblem problem, List<Curve> curves) {
        return chart(problem.title() + ": " + cheapest(curves), "evaluations of the derivative", problem, curves,
                Point::evaluations, true);
    }

    /**
     * @param problem what was solved
     * @param curves  by whom
     * @return error against measured time
     */
    public static ChartData byTime(WorkProblem problem, List<Curve> curves) {
        return chart(problem.title() + ", by the clock", "median time (s)", problem, curves, Point::seconds, false);
    }

    private static ChartData chart(String title, String label, WorkProblem problem, List<Curve> curves,
                                   ToDoubleFunction<Point> work, boolean slopes) {
        List<Series> series = new ArrayList<>();
        List<Double> failed = new ArrayList<>();
        for (Curve curve : curves) {
            List<Point> good = curve.points().stream().filter(point -> point.failure().isEmpty() && point.error() > 0).toList();
            series.add(new Series(curve.solver().label() + (slopes ? slope(curve) : ""), Mark.LINE_AND_POINTS,
                    good.stream().mapToDouble(work).toArray(), good.stream().mapToDouble(Point::error).toArray()));
            curve.points().stream().filter(point -> point.failure().isPresent()).forEach(p -> failed.add(work.applyAsDouble(p)));
        }
        if (!failed.isEmpty()) {
            double[] x = failed.stream().mapToDouble(Double::doubleValue).toArray();
            double[] y = failed.stream().mapToDouble(p -> FAILED).toArray();
            series.add(new Series("no result: unstable or not converged", Mark.FAILURES, x, y));
        }
        return new ChartData(title, label, problem.errorLabel(), true, true, series);
    }

    private static String slope(Curve curve) {
        return Double.isNaN(curve.slope()) ? ", no slope" : String.format(Locale.ROOT, ", slope %.2f", curve.slope());
    }

    /** Who needs the fewest evaluations for a rough and for a fine result. */
    private static String cheapest(List<Curve> curves) {
        String rough = cheapest(curves, 1e-2);
        String fine = cheapest(curves, 1e-6);
        return rough.equals(fine) ? "an error of 1e-2 or of 1e-6 costs " + rough + " least"
                : "1e-2 costs " + rough + " least, 1e-6 costs " + fine + " least";
    }

    private static String cheapest(List<Curve> curves, double error) {
        String best = "nobody";
        double least = Double.POSITIVE_INFINITY;
        for (Curve curve : curves) {
            for (Point point : curve.points()) {
                if (point.error() <= error && point.evaluations() < least) {
                    least = point.evaluations();
                    best = curve.solver().label();
                }
            }
        }
        return best;
    }

    /**
     * @param all the curves of each problem
     * @return fitted slopes beside the solvers' orders
     */
    public static DataTable slopes(Map<WorkProblem, List<Curve>> all) {
        List<List<Object>> rows = new ArrayList<>();
        all.forEach((problem, curves) -> curves.forEach(curve -> rows.add(List.of(problem.name(), curve.solver().label(),
                curve.slope(), curve.solver().adaptive() ? "by tolerance" : "by deltaT", curve.expected(), curve.points().size(),
                curve.points().stream().filter(point -> point.failure().isPresent()).count()))));
        return new DataTable("slopes", "Fitted slopes beside the orders", List.of(DataTable.column("problem"),
                DataTable.column("solver"), new DataTable.Column("slope", 3), DataTable.column("varied"), DataTable.column("order"),
                DataTable.column("runs"), DataTable.column("without result")), rows);
    }

    /**
     * @param all the curves of each problem
     * @return every run
     */
    public static DataTable runs(Map<WorkProblem, List<Curve>> all) {
        List<List<Object>> rows = new ArrayList<>();
        all.forEach((problem, curves) -> curves.forEach(curve -> curve.points().forEach(p -> rows.add(List.of(problem.name(),
                curve.solver().label(), p.deltaT(), p.tolerance(), p.evaluations(), p.error(), p.seconds(), p.least(), p.most(),
                p.failure().orElse(""))))));
        return new DataTable("runs", "Every run; times are medians of three after one to warm up", List.of(DataTable.column("problem"),
                DataTable.column("solver"), DataTable.column("deltaT (s)"), new DataTable.Column("tolerance", 2),
                DataTable.column("evaluations"), new DataTable.Column("error", 3), new DataTable.Column("time (s)", 2),
                new DataTable.Column("fastest (s)", 2), new DataTable.Column("slowest (s)", 2), DataTable.column("why no result")), rows);
    }
}
