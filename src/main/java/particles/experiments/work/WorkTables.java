package particles.experiments.work;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import particles.experiments.work.WorkPrecision.Curve;
import particles.experiments.work.WorkPrecision.Failure;
import particles.experiments.work.WorkPrecision.Point;
import particles.view.DataTable;

/** The tables behind work-precision diagrams. */
public final class WorkTables {
    private WorkTables() {
    }

    /**
     * @param all the curves of each problem
     * @return the fitted slopes, the theoretical ones, and the runs that were fitted
     */
    public static DataTable slopes(Map<WorkProblem, List<Curve>> all) {
        List<List<Object>> rows = new ArrayList<>();
        all.forEach((problem, curves) -> curves.forEach(curve -> rows.add(slope(problem, curve))));
        return new DataTable("slopes",
                "Fitted slopes beside theory; a fit is of the runs from the coarsest to the finest fitted",
                List.of(DataTable.column("problem"), DataTable.column("solver"), new DataTable.Column("slope", 3),
                        DataTable.column("theory"), DataTable.column("order"), DataTable.column("varied"),
                        new DataTable.Column("coarsest fitted", 3), new DataTable.Column("finest fitted", 3),
                                DataTable.column("fitted"),
                        DataTable.column("runs"), DataTable.column("unstable"), DataTable.column("not converged"),
                        DataTable.column("why no slope")), rows);
    }

    private static List<Object> slope(WorkProblem problem, Curve curve) {
        List<Point> points = curve.points();
        SlopeFit fit = curve.fit();
        boolean none = Double.isNaN(fit.slope());
        return List.of(problem.name(), curve.solver().label(), fit.slope(), curve.expected(), curve.solver().order(),
                curve.byStep() ? "deltaT (s)" : "tolerance", none ? Double.NaN : varied(curve, points.get(fit.first())),
                none ? Double.NaN : varied(curve, points.get(fit.last())), none ? 0 : fit.last() - fit.first() + 1,
                        points.size(),
                failed(points, Failure.UNSTABLE), failed(points, Failure.NOT_CONVERGED), fit.whyNot());
    }

    private static double varied(Curve curve, Point point) {
        return curve.byStep() ? point.deltaT() : point.tolerance();
    }

    private static long failed(List<Point> points, Failure kind) {
        return points.stream().filter(point -> point.failure().equals(Optional.of(kind))).count();
    }

    /**
     * @param all the curves of each problem
     * @return every run
     */
    public static DataTable runs(Map<WorkProblem, List<Curve>> all) {
        List<List<Object>> rows = new ArrayList<>();
        all.forEach((problem, curves) -> curves.forEach(curve -> {
            for (int k = 0; k < curve.points().size(); k++) {
                Point p = curve.points().get(k);
                rows.add(List.of(problem.name(), curve.solver().label(), p.deltaT(), p.tolerance(), p.evaluations(),
                        p.error(),
                        curve.fit().contains(k) ? "yes" : "", p.seconds(), p.lower(), p.upper(), p.failure().map(kind ->
                        kind == Failure.UNSTABLE ? "unstable" : "did not converge").orElse(""), p.why()));
            }
        }));
        return new DataTable("runs", "Every run; times are medians of five or more runs that were warmed up", List.of(
                DataTable.column("problem"), DataTable.column("solver"), DataTable.column("deltaT (s)"),
                new DataTable.Column("tolerance", 2), DataTable.column("evaluations"), new DataTable.Column("error", 3),
                DataTable.column("fitted"), new DataTable.Column("time (s)", 2),
                new DataTable.Column("lower quartile (s)", 2),
                new DataTable.Column("upper quartile (s)", 2), DataTable.column("no result"), DataTable.column("why")),
                rows);
    }
}
