package particles.experiments.work;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.DEStateSource;
import deSolvers.catalog.SolverCatalog;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import particles.experiments.runs.FittedLine;
import particles.experiments.runs.SolverChoice;
import particles.experiments.work.CostExercise.Cost;
import particles.experiments.work.WorkPrecision.Run;
import particles.view.Chart;

class WorkPrecisionTest {
    private static List<Run> runs(String problem, String solver) {
        return WorkPrecision.runs(WorkProblem.of(problem), SolverChoice.of(solver));
    }

    /** Measured: at most 0.06 off (adams on the network, 3.95). No end time is a multiple of a period. */
    @Tag("slow")
    @ParameterizedTest
    @ValueSource(strings = {"oscillator", "pendulum", "kepler", "network"})
    void slopesOfFixedStepsAreTheOrders(String problem) {
        WorkProblem solved = WorkProblem.of(problem);
        for (SolverChoice solver : SolverChoice.list("all").stream().filter(one -> !one.adaptive()).toList()) {
            assertEquals(solver.order(), WorkPrecision.slope(WorkPrecision.runs(solved, solver)), 0.1,
                    solver.label() + " on " + problem);
            assertEquals(solver.order(), WorkPrecision.theory(solved, solver));
        }
    }

    /**
     * Theory: E. Hairer and G. Wanner, Solving Ordinary Differential Equations II, table IV.15.1; measured 2.98, 2.00,
     * 1.00.
     */
    @Test
    void theStiffChainReducesTheOrderOfRadauToThatOfItsStages() {
        List<Run> radau = runs("stiff-chain", "radau");
        assertEquals(3, WorkPrecision.slope(radau), 0.1);
        assertEquals(2, WorkPrecision.slope(runs("stiff-chain", "implicit-midpoint")), 0.05);
        assertEquals(1, WorkPrecision.slope(runs("stiff-chain", "backward-euler")), 0.05);
        // steps as short as the springs' time have the whole order again: from n = 512 to 1024 steps
        assertEquals(5, Math.log(radau.get(7).error() / radau.get(8).error()) / Math.log(2), 0.2);
        assertTrue(WorkPrecision.slopes(radau).matches("2[.]9\\d \\(3\\)"), WorkPrecision.slopes(radau));
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

    /** The runs of two rounds are equal but for their times, and the faster round counts. */
    @Tag("slow")
    @Test
    void evaluationsAndErrorsAreTheSameInAllRounds() {
        List<WorkProblem> problems = List.of(WorkProblem.of("network"), WorkProblem.of("stiff-chain"));
        List<SolverChoice> solvers = SolverChoice.list("rk4, adams, dormand-prince, backward-euler");
        List<Run> all = WorkPrecision.measure(problems, solvers, (part, what) -> { });
        List<Run> once = problems.stream().flatMap(problem -> solvers.stream().flatMap(solver ->
                WorkPrecision.runs(problem, solver).stream())).toList();
        assertEquals(once.stream().map(Run::evaluations).toList(), all.stream().map(Run::evaluations).toList());
        assertEquals(once.stream().map(Run::error).toList(), all.stream().map(Run::error).toList());
        assertTrue(all.stream().allMatch(run -> run.seconds() > 0));
    }

    @Test
    void failuresAreDrawnBelowTheErrors() {
        List<Run> rk4 = runs("stiff-chain", "rk4");
        assertTrue(Double.isNaN(rk4.get(0).error()), "a step of 0.125 s for omega = 1407 1/s");
        assertTrue(rk4.get(rk4.size() - 1).failure().isEmpty());
        List<Run> verlet = runs("stiff-chain", "verlet");
        assertTrue(verlet.get(0).failure().contains("did not converge"), verlet.get(0).failure());
        List<Run> implicit = runs("stiff-chain", "backward-euler");
        assertTrue(implicit.stream().allMatch(run -> run.failure().isEmpty()));
        List<Run> all = Stream.of(rk4, implicit, verlet).flatMap(List::stream).toList();
        for (List<Chart> charts : List.of(WorkPrecision.byEvaluations(all).charts(),
                WorkPrecision.byTime(all).charts())) {
            assertTrue(Double.isNaN(charts.get(0).series().get(0).y()[0]), "a gap, and no line across it");
            Chart below = charts.get(1);
            assertEquals(List.of("rk4", "verlet"), below.rows());
            assertEquals(all.stream().filter(run -> !run.failure().isEmpty()).count(),
                    below.series().stream().mapToLong(series -> series.x().length).sum());
        }
        assertEquals(1, WorkPrecision.byEvaluations(implicit).charts().size(), "nothing failed");
    }

    /** A line of slope 2 whose finest error is round-off, one that bends, and one that is too short. */
    @Test
    void slopesAreOfTheFinestThreeRunsOrNone() {
        assertEquals(2, fit(0.5, 0.3, 1e-2, 2.5e-3, 6.25e-4, 1.5625e-4, 1e-14), 1e-12);
        assertEquals(Double.NaN, fit(1e-2, 5e-3, 1e-3, 4e-4, 0.2e-4));
        assertEquals(Double.NaN, fit(1e-2, 2.5e-3, 1e-14));
    }

    /** On the stiff chain the error falls with the 7th power of the work where sub-steps become stable: no order. */
    @ParameterizedTest
    @ValueSource(strings = {"dormand-prince", "rk4"})
    void whatFallsAtTheEdgeOfStabilityIsNoOrder(String solver) {
        assertEquals("no slope", WorkPrecision.slopes(runs("stiff-chain", solver)));
    }

    private static double fit(double... errors) {
        WorkProblem problem = WorkProblem.of("oscillator");
        return WorkPrecision.slope(IntStream.range(0, errors.length).mapToObj(k -> new Run(problem, SolverChoice.RK4,
                Math.pow(2, -k), Double.NaN, 1L << k, errors[k], 1, "")).toList());
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
