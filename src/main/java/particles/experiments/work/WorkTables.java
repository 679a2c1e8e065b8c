package particles.experiments.work;

import static particles.view.DataTable.column;

import java.util.List;
import java.util.stream.IntStream;
import particles.experiments.work.WorkPrecision.Curve;
import particles.experiments.work.WorkPrecision.Failure;
import particles.experiments.work.WorkPrecision.Point;
import particles.view.DataTable;

/** The tables behind work-precision diagrams. */
public final class WorkTables {
    private WorkTables() {
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
        return DataTable.of("runs", "Every run; times are medians of five or more runs that were warmed up",
                curves.stream().flatMap(curve -> IntStream.range(0, curve.points().size()).mapToObj(k ->
                        new Row(curve, k, curve.points().get(k)))).toList(),
                column("problem", row -> row.curve.problem().name()), column("solver", row -> row.curve.label()),
                column("deltaT (s)", row -> row.point.deltaT()), column("tolerance", 2, row -> row.point.tolerance()),
                column("evaluations", row -> row.point.evaluations()), column("error", 3, row -> row.point.error()),
                column("fitted", row -> row.curve.fit().contains(row.k) ? "yes" : ""),
                column("time (s)", 2, row -> row.point.seconds()),
                column("lower quartile (s)", 2, row -> row.point.lower()),
                column("upper quartile (s)", 2, row -> row.point.upper()),
                column("no result", row -> row.point.failure().map(Failure::words).orElse("")),
                column("why", row -> row.point.why()));
    }
}
