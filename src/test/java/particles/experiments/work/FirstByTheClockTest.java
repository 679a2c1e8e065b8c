package particles.experiments.work;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import particles.experiments.runs.SolverChoice;
import particles.experiments.work.WorkPrecision.Curve;
import particles.experiments.work.WorkPrecision.Point;

/** Who is called first in a time chart, on made-up times with known quartiles. */
class FirstByTheClockTest {
    private static final WorkProblem PROBLEM = WorkProblems.of("oscillator");

    private static Point point(double error, double lower, double median, double upper) {
        return new Point(0.1, Double.NaN, 100, error, median, lower, upper, Optional.empty(), "");
    }

    private static Curve curve(String solver, Point... points) {
        return new Curve(SolverChoice.of(solver), true, List.of(points),
                SlopeFit.byStep(List.of(points), PROBLEM, false, 4), 4);
    }

    private static String title(Curve... curves) {
        return WorkCharts.byTime(PROBLEM, Arrays.asList(curves)).get(0).title();
    }

    @Test
    void oneSolverIsFirstWhereNoQuartilesOverlap() {
        String title = title(curve("rk4", point(1e-3, 1, 2, 3)), curve("verlet", point(1e-3, 3.1, 4, 5)));
        assertTrue(title.endsWith(": rk4 is first to 0.01, none has 1e-6"), title);
    }

    @Test
    void solversWhoseQuartilesOverlapTie() {
        List<Curve> curves = List.of(curve("verlet", point(1e-3, 2.9, 4, 5)), curve("rk4", point(1e-3, 1, 2, 3)),
                curve("euler", point(1e-3, 6, 7, 8)));
        assertEquals(List.of("rk4", "verlet"), WorkCharts.first(curves, 1e-2, true));
        assertTrue(title(curves.toArray(Curve[]::new)).contains(": rk4 and verlet tie for 0.01,"));
    }

    /** Each solver counts by its cheapest run that is precise enough: verlet's fast one is too rough for 1e-6. */
    @Test
    void roughAndFineAreToldApart() {
        String title = title(curve("rk4", point(1e-3, 4, 5, 6), point(1e-7, 7, 8, 9)),
                curve("verlet", point(1e-3, 1, 2, 3), point(1e-7, 20, 21, 22)));
        assertTrue(title.endsWith(": verlet is first to 0.01, rk4 is first to 1e-6"), title);
    }

    @Test
    void manyThatTieAreCounted() {
        Curve[] curves = List.of("rk4", "verlet", "euler", "midpoint").stream()
                .map(name -> curve(name, point(1e-7, 1, 2, 3))).toArray(Curve[]::new);
        assertTrue(title(curves).endsWith(": 4 solvers tie for 0.01 and 1e-6"));
    }
}
