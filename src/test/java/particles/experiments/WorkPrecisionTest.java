package particles.experiments;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.NoSuchElementException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.ChartData;
import particles.experiments.CostExercise.Cost;
import particles.experiments.WorkPrecision.Curve;
import particles.experiments.WorkPrecision.Point;
import particles.experiments.problems.WorkProblem;
import particles.experiments.problems.WorkProblems;

class WorkPrecisionTest {
    private static Curve curve(String problem, String solver) {
        return WorkPrecision.measure(WorkProblems.of(problem), SolverChoice.of(solver));
    }

    @ParameterizedTest
    @CsvSource({"oscillator, euler", "oscillator, midpoint", "oscillator, rk4", "oscillator, symplectic-euler", "oscillator, verlet",
        "pendulum, midpoint", "pendulum, rk4", "pendulum, yoshida4", "pendulum, adams", "pendulum, implicit-midpoint",
        "kepler, rk4", "kepler, verlet", "kepler, yoshida4"})
    void slopesOfFixedStepsAreTheOrders(String problem, String solver) {
        Curve curve = curve(problem, solver);
        assertEquals(curve.expected(), curve.slope(), 0.1);
    }

    @Test
    void evaluationsAndErrorsAreTheSameInTwoRuns() {
        for (String solver : List.of("rk4", "dormand-prince", "backward-euler")) {
            List<Point> once = curve("network", solver).points();
            List<Point> again = curve("network", solver).points();
            assertEquals(once.stream().map(Point::evaluations).toList(), again.stream().map(Point::evaluations).toList());
            assertEquals(once.stream().map(Point::error).toList(), again.stream().map(Point::error).toList());
        }
    }

    @Test
    void timesAreMedians() {
        for (Point point : curve("network", "midpoint").points()) {
            assertTrue(point.least() <= point.seconds() && point.seconds() <= point.most() && point.least() > 0);
        }
    }

    @Test
    void unstableRunsAreFailuresInTheDiagram() {
        WorkProblem chain = WorkProblems.of("stiff-chain");
        Curve explicit = WorkPrecision.measure(chain, SolverChoice.of("rk4"));
        assertTrue(explicit.points().get(0).failure().isPresent(), "a step of 0.19 s for omega = 1414 1/s");
        assertTrue(explicit.points().get(explicit.points().size() - 1).failure().isEmpty());
        Curve implicit = WorkPrecision.measure(chain, SolverChoice.of("backward-euler"));
        assertTrue(implicit.points().stream().allMatch(point -> point.failure().isEmpty()));
        List<ChartData.Series> series = WorkCharts.byEvaluations(chain, List.of(explicit, implicit)).series();
        assertEquals(ChartData.Mark.FAILURES, series.get(2).mark());
        assertEquals(explicit.points().stream().filter(point -> point.failure().isPresent()).count(), series.get(2).x().length);
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
        assertEquals(3, WorkPrecision.slope(new double[] {1, 2, 4, 8}, new double[] {5, 40, 320, 2560}), 1e-12);
        assertTrue(Double.isNaN(WorkPrecision.slope(new double[] {1, 2}, new double[] {1, 2})));
    }

    @Test
    void unknownProblemIsMet() {
        String message = assertThrows(NoSuchElementException.class, () -> WorkProblems.of("keplar")).getMessage();
        assertTrue(message.contains("did you mean 'kepler'"), message);
        assertFalse(WorkProblems.of("stiff-chain").smooth());
    }
}
