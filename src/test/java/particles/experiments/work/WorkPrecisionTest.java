package particles.experiments.work;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.DEStateSource;
import deSolvers.catalog.SolverCatalog;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import particles.experiments.lecture.CostExercise;
import particles.experiments.lecture.CostExercise.Cost;
import particles.experiments.runs.FittedLine;
import particles.experiments.runs.SolverChoice;
import particles.experiments.work.WorkPrecision.Curve;
import particles.experiments.work.WorkPrecision.Failure;
import particles.experiments.work.WorkPrecision.Point;
import particles.experiments.work.WorkPrecision.SlopeFit;
import particles.view.Chart;
import particles.view.Series;
import particles.view.Series.Mark;

class WorkPrecisionTest {
    private static Curve curve(String problem, String solver) {
        return curve(WorkProblem.of(problem), solver);
    }

    private static Curve curve(WorkProblem problem, String solver) {
        return new WorkPrecision(problem, SolverChoice.of(solver)).curve();
    }

    /** Measured: at most 0.08 off (adams on the network, 4.07). No end time is a multiple of a period. */
    @Tag("slow")
    @ParameterizedTest
    @ValueSource(strings = {"oscillator", "pendulum", "kepler", "network"})
    void slopesOfFixedStepsAreTheOrders(String problem) {
        WorkProblem solved = WorkProblem.of(problem);
        for (SolverChoice solver : SolverChoice.list("all").stream().filter(one -> !one.adaptive()).toList()) {
            Curve curve = new WorkPrecision(solved, solver).curve();
            assertEquals(solver.order(), curve.fit().slope(), 0.1, solver.label() + " on " + problem);
            assertEquals(solver.order(), curve.expected());
            assertEquals(3, curve.fitted().size());
            for (Point point : curve.fitted()) {
                assertTrue(point.error() > solved.floor() && point.error() < SlopeFit.SMALL, "in range: " + point);
            }
        }
    }

    /**
     * Theory: E. Hairer and G. Wanner, Solving Ordinary Differential Equations II, table IV.15.1; measured 2.98, 2.00,
     * 1.00.
     */
    @Test
    void theStiffChainReducesTheOrderOfRadauToThatOfItsStages() {
        Curve radau = curve("stiff-chain", "radau");
        assertEquals(3, radau.expected());
        assertEquals(3, radau.fit().slope(), 0.1);
        assertEquals(2, curve("stiff-chain", "implicit-midpoint").fit().slope(), 0.05);
        assertEquals(1, curve("stiff-chain", "backward-euler").fit().slope(), 0.05);
        // steps as short as the springs' time have the whole order again: from n = 512 to 1024 steps
        assertEquals(5, Math.log(radau.points().get(7).error() / radau.points().get(8).error()) / Math.log(2), 0.2);
        assertTrue(WorkCharts.slope(radau).matches("2[.]9\\d \\(3\\)"), WorkCharts.slope(radau));
    }

    /** Solvers of different kinds at 1e-13 differ by less than a fifth of what fits begin at. */
    @ParameterizedTest
    @ValueSource(strings = {"pendulum", "network", "cloth", "stiff-chain"})
    void referencesAreWhatAnotherSolverFinds(String problem) {
        WorkProblem solved = WorkProblem.of(problem);
        DEStateSource source = solved.start().get();
        SolverCatalog.create("dormand-prince", 1e-13, 1e-13).stepState(source, solved.duration());
        double error = solved.error(source);                // measured 8e-13, 2e-13, 1e-13, and 2e-16 of 1e-14
        assertTrue(error < solved.floor() / 5, "measured " + error);
    }

    @Tag("slow")
    @Test
    void evaluationsAndErrorsAreTheSameInTwoRuns() {
        for (String problem : List.of("network", "stiff-chain")) {
            WorkProblem solved = WorkProblem.of(problem);
            for (String solver : List.of("rk4", "adams", "dormand-prince", "backward-euler")) {
                List<Point> once = curve(solved, solver).points();
                List<Point> again = curve(solved, solver).points();
                assertEquals(once.stream().map(Point::evaluations).toList(),
                        again.stream().map(Point::evaluations).toList());
                assertEquals(once.stream().map(Point::error).toList(), again.stream().map(Point::error).toList());
            }
        }
    }

    @Test
    void anotherRoundAddsATimeToTheSameRuns() {
        Curve once = curve("network", "dormand-prince");
        List<Point> again = once.timedAgain().points();
        for (int k = 0; k < again.size(); k++) {
            Point point = again.get(k);
            assertEquals(once.points().get(k).error(), point.error());
            assertTrue(point.times().size() == 2 && point.fastest() <= point.median() && point.fastest() > 0);
        }
    }

    @Test
    void failuresAreDrawnByKindBelowTheErrors() {
        WorkProblem chain = WorkProblem.of("stiff-chain");
        Curve rk4 = curve(chain, "rk4");
        assertEquals(Optional.of(Failure.UNSTABLE), rk4.points().get(0).failure(),
                "a step of 0.125 s for omega = 1407 1/s");
        assertTrue(rk4.points().get(rk4.points().size() - 1).failure().isEmpty());
        Curve verlet = curve(chain, "verlet");
        assertEquals(Optional.of(Failure.NOT_CONVERGED), verlet.points().get(0).failure(),
                verlet.points().get(0).why());
        Curve implicit = curve(chain, "backward-euler");
        assertTrue(implicit.points().stream().allMatch(point -> point.failure().isEmpty()));
        for (List<Chart> charts : List.of(WorkCharts.byEvaluations(List.of(rk4, implicit, verlet)).charts(),
                WorkCharts.byTime(List.of(rk4, implicit, verlet)).charts())) {
            assertTrue(Double.isNaN(charts.get(0).series().get(0).y()[0]), "a gap, and no line across it");
            Chart below = charts.get(1);
            assertEquals(List.of("rk4", "verlet"), below.rows());
            assertEquals(Set.of(Mark.FAILURES, Mark.GIVEN_UP),
                    below.series().stream().map(Series::mark).collect(Collectors.toSet()));
            assertEquals(failed(rk4) + failed(verlet),
                    below.series().stream().mapToLong(series -> series.x().length).sum());
        }
        assertEquals(1, WorkCharts.byEvaluations(List.of(implicit)).charts().size(), "nothing failed");
    }

    private static long failed(Curve curve) {
        return curve.points().stream().filter(point -> point.failure().isPresent()).count();
    }

    /** Filled points are the fitted ones, on top of the hollow ones of the same line. */
    @Test
    void fittedPointsAreMarked() {
        WorkProblem network = WorkProblem.of("network");
        Curve rk4 = curve(network, "rk4");
        List<Series> series = WorkCharts.byEvaluations(List.of(rk4)).charts().get(0).series();
        assertEquals(List.of(Mark.LINE_AND_OPEN_POINTS, Mark.FITTED_POINTS), series.subList(0,
                2).stream().map(Series::mark).toList());
        assertEquals(3, series.get(1).x().length);
        assertEquals(rk4.fitted().get(2).error(), series.get(1).y()[2]);
        assertTrue(series.get(1).x().length < series.get(0).x().length, "the coarsest and the finest are not fitted");
    }

    /** A line of slope 2 whose finest error is round-off, one that bends, and one that is too short. */
    @Test
    void slopesAreOfTheFinestThreeRunsOrNone() {
        SlopeFit straight = fit(0.5, 0.3, 1e-2, 2.5e-3, 6.25e-4, 1.5625e-4, 1e-14);
        assertEquals(2, straight.slope(), 1e-12);
        assertEquals(List.of(3, 4, 5), straight.runs());
        SlopeFit bent = fit(1e-2, 5e-3, 1e-3, 4e-4, 0.2e-4);
        assertTrue(Double.isNaN(bent.slope()) && bent.runs().isEmpty());
        assertEquals("not on a straight line", bent.whyNot());
        SlopeFit few = fit(1e-2, 2.5e-3, 1e-14);
        assertTrue(Double.isNaN(few.slope()) && few.whyNot().startsWith("2 errors"), few.whyNot());
    }

    /** On the stiff chain the error falls with the 7th power of the work where sub-steps become stable: no order. */
    @ParameterizedTest
    @ValueSource(strings = {"dormand-prince", "rk4"})
    void whatFallsAtTheEdgeOfStabilityIsNoOrder(String solver) {
        Curve curve = curve("stiff-chain", solver);
        assertEquals("not on a straight line", curve.fit().whyNot());
        assertEquals("", WorkCharts.slope(curve));
        assertEquals(List.of(), curve.fitted());
    }

    private static SlopeFit fit(double... errors) {
        List<Point> points = IntStream.range(0, errors.length).mapToObj(k -> new Point(Math.pow(2, -k), Double.NaN,
                1L << k, errors[k], List.of(1.0), Optional.empty(), "")).toList();
        return SlopeFit.of(points, WorkProblem.of("oscillator").floor(), true, 0);
    }

    /** The counts of the reference are good to about 1 %. */
    @Test
    void exerciseHasItsAnswer() {
        List<Cost> costs = CostExercise.solve();
        long[][] known = {{2608, 680}, {8166, 1208}, {25848, 2152}, {82178, 3860}, {819326, 12180}};
        for (int k = 0; k < known.length; k++) {
            assertEquals(1, (double) costs.get(k).midpoint() / known[k][0], 0.03);
            assertEquals(1, (double) costs.get(k).rk4() / known[k][1], 0.03);
        }
        assertEquals(67.3, (double) CostExercise.table(costs).rows().get(4).get(3), 2);
    }

    @Test
    void fitIsAPowerLaw() {
        assertEquals(3, FittedLine.exponent(List.of(1, 2, 4, 8), x -> x, x -> 5 * x * x * x), 1e-12);
        assertTrue(Double.isNaN(FittedLine.exponent(List.of(1, 2), x -> x, x -> x)));
    }
}
