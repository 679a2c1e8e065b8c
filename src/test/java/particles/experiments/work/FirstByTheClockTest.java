package particles.experiments.work;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.experiments.runs.SolverChoice;
import particles.experiments.work.WorkPrecision.Curve;
import particles.experiments.work.WorkPrecision.Point;
import particles.experiments.work.WorkPrecision.SlopeFit;

/** Who is called first in a time chart, on made-up times with known quartiles. */
class FirstByTheClockTest {
    private static final WorkProblem PROBLEM = WorkProblem.of("oscillator");

    /** Runs of a solver: error, lower quartile, median and upper quartile; verlet's fast one is too rough for 1e-6. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            rk4 1e-3 1 2 3; verlet 1e-3 3.1 4 5 | rk4 is first to 0.01, none has 1e-6
            verlet 1e-3 2.9 4 5; rk4 1e-3 1 2 3; euler 1e-3 6 7 8 | rk4 and verlet tie for 0.01, none has 1e-6
            rk4 1e-3 4 5 6 1e-7 7 8 9; verlet 1e-3 1 2 3 1e-7 20 21 22 \
            | verlet is first to 0.01, rk4 is first to 1e-6
            rk4 1e-7 1 2 3; verlet 1e-7 1 2 3; euler 1e-7 1 2 3; midpoint 1e-7 1 2 3 | 4 solvers tie for 0.01 and 1e-6
            """)
    void solversAreFirstOrTieByTheirQuartiles(String runs, String title) {
        List<Curve> curves = Stream.of(runs.split("; ")).map(FirstByTheClockTest::curve).toList();
        assertEquals(PROBLEM.title() + ": " + title, WorkCharts.byTime(curves).get(0).title());
    }

    private static Curve curve(String text) {
        String solver = text.replaceFirst(" .*", "");
        double[] numbers = Stream.of(text.split(" ")).skip(1).mapToDouble(Double::parseDouble).toArray();
        List<Point> points = IntStream.range(0, numbers.length / 4).mapToObj(k -> new Point(0.1, Double.NaN, 100,
                numbers[4 * k], numbers[4 * k + 2], numbers[4 * k + 1], numbers[4 * k + 3], Optional.empty(), ""))
                .toList();
        return new Curve(PROBLEM, SolverChoice.of(solver), true, points,
                SlopeFit.of(points, PROBLEM.floor(), true, 0, 4), 4);
    }
}
