package particles.experiments.work;

import static particles.view.DataTable.column;

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
        record Row(WorkProblem problem, Curve curve, SlopeFit fit) {
            Object varied(int run) {
                return Double.isNaN(fit.slope()) ? Double.NaN : curve.varied(curve.points().get(run));
            }
        }
        List<Row> rows = new ArrayList<>();
        all.forEach((problem, curves) -> curves.forEach(curve -> rows.add(new Row(problem, curve, curve.fit()))));
        return DataTable.of("slopes",
                "Fitted slopes beside theory; a fit is of the runs from the coarsest to the finest fitted", rows,
                column("problem", row -> row.problem.name()), column("solver", row -> row.curve.solver().label()),
                column("slope", 3, row -> row.fit.slope()), column("theory", row -> row.curve.expected()),
                column("order", row -> row.curve.solver().order()),
                column("varied", row -> row.curve.byStep() ? "deltaT (s)" : "tolerance"),
                column("coarsest fitted", 3, row -> row.varied(row.fit.first())),
                column("finest fitted", 3, row -> row.varied(row.fit.last())),
                column("fitted", row -> row.fit.last() - row.fit.first() + 1),
                column("runs", row -> row.curve.points().size()),
                column("unstable", row -> failed(row.curve, Failure.UNSTABLE)),
                column("not converged", row -> failed(row.curve, Failure.NOT_CONVERGED)),
                column("why no slope", row -> row.fit.whyNot()));
    }

    private static long failed(Curve curve, Failure kind) {
        return curve.points().stream().filter(point -> point.failure().equals(Optional.of(kind))).count();
    }

    /**
     * @param all the curves of each problem
     * @return every run
     */
    public static DataTable runs(Map<WorkProblem, List<Curve>> all) {
        record Row(WorkProblem problem, Curve curve, int k, Point point) {
        }
        List<Row> rows = new ArrayList<>();
        all.forEach((problem, curves) -> curves.forEach(curve -> {
            for (int k = 0; k < curve.points().size(); k++) {
                rows.add(new Row(problem, curve, k, curve.points().get(k)));
            }
        }));
        return DataTable.of("runs", "Every run; times are medians of five or more runs that were warmed up", rows,
                column("problem", row -> row.problem.name()), column("solver", row -> row.curve.solver().label()),
                column("deltaT (s)", row -> row.point.deltaT()), column("tolerance", 2, row -> row.point.tolerance()),
                column("evaluations", row -> row.point.evaluations()), column("error", 3, row -> row.point.error()),
                column("fitted", row -> row.curve.fit().contains(row.k) ? "yes" : ""),
                column("time (s)", 2, row -> row.point.seconds()),
                column("lower quartile (s)", 2, row -> row.point.lower()),
                column("upper quartile (s)", 2, row -> row.point.upper()),
                column("no result", row -> row.point.failure().map(kind -> kind == Failure.UNSTABLE ? "unstable"
                        : "did not converge").orElse("")), column("why", row -> row.point.why()));
    }
}
