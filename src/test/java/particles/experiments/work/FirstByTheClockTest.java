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

/** Who is called first in a time chart, on made-up times. */
class FirstByTheClockTest {
    private static final WorkProblem PROBLEM = WorkProblem.of("oscillator");

    /** Runs of a solver: error, time of the fastest round and median; each finer one of the fifth takes less. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            rk4 1 1 1 1e-3 4 6; verlet 1 1 1 1e-3 6.1 7 | rk4 is first to an error of 0.01, no run reaches 1e-6
            verlet 1 1 1 1e-3 5.9 7; rk4 1 1 1 1e-3 4 6; euler 1 1 1 1e-3 12 13 \
            | rk4 and verlet tie for an error of 0.01, no run reaches 1e-6
            rk4 1 1 1 1e-3 4 5 1e-7 7 8; verlet 1e-3 1 2 1e-7 20 21 \
            | verlet is first to an error of 0.01, rk4 is first to 1e-6
            rk4 1 1 2; verlet 1 1 2; euler 1 1 2; midpoint 1 1 2 | no run reaches an error of 0.01
            rk4 1 5 6 1e-7 1 2; verlet 1 3 3 1e-7 3 4 | rk4 is first to an error of 0.01 and 1e-6
            rk4 1e-3 4 5 1e-7 7 8 | rk4 reaches an error of 1e-6
            rk4 1e-9 1 3 | every stable run has an error below 1e-9
            rk4 1e-9 1 3; verlet 1e-9 2 3; euler 1.7e-8 1 2; midpoint 1e-9 2 3; adams 1e-9 4 5 \
            | every stable run has an error below 2e-8; 4 solvers are stable in the least time
            """)
    void solversAreFirstOrTieByTheirBars(String runs, String title) {
        List<Curve> curves = Stream.of(runs.split("; ")).map(FirstByTheClockTest::curve).toList();
        assertEquals(PROBLEM.title() + ": " + title, WorkCharts.byTime(curves).get(0).title());
    }

    private static Curve curve(String text) {
        String solver = text.replaceFirst(" .*", "");
        double[] numbers = Stream.of(text.split(" ")).skip(1).mapToDouble(Double::parseDouble).toArray();
        List<Point> points = IntStream.range(0, numbers.length / 3).mapToObj(k -> new Point(0.1, Double.NaN, 100,
                numbers[3 * k], List.of(numbers[3 * k + 1], numbers[3 * k + 2]), Optional.empty(), "")).toList();
        return new Curve(PROBLEM, SolverChoice.of(solver), true, points,
                SlopeFit.of(points, PROBLEM.floor(), true, 0, 4), 4);
    }
}
