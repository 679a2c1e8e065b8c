package particles.experiments.grid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.experiments.grid.Grid.Row;
import particles.scene.SceneReader;
import particles.spec.ClassNames;
import particles.view.Series;

/** Laws that rows of a grid have to follow. */
class SceneGridTest {
    private static final double STIFFNESS = 100;

    @TempDir
    Path top;

    private static List<Row> rows(String scene, String vary, String measures) {
        return rows(Path.of("scenes", scene), vary, measures);
    }

    private List<Row> rowsOf(String text, String vary, String measures) throws IOException {
        return rows(Files.writeString(top.resolve("scene.yaml"), text), vary, measures);
    }

    private static List<Row> rows(Path scene, String vary, String measures) {
        Grid grid = new Grid(GridAxis.list(vary));
        SceneGrid runs = new SceneGrid(settings -> SceneReader.read(scene, ClassNames.none(), settings), grid,
                Measure.list(measures), "--vary");
        return grid.points().stream().map(runs::run).toList();
    }

    /**
     * x'' = -100 x - c x' from rest at x = 1 turns at t = k pi/omega, where x = (-1)^k exp(-c t/2); its maxima are
     * 2 pi/omega apart. Measured: 4.4e-8 of the amplitude and
     * 2.9e-9 s, and 1.9e-7 J between the spring's work and the kinetic energy.
     */
    @Test
    void amplitudeAndPeriodOfADampedSpringFollowTheFormula() {
        for (Row row : rows("03-damped-spring.yaml", "springs[0].damping = 0.5 .. 4 by 0.5; deltaT = 0.002",
                "amplitude x of block, period x of block, energy lost, work of springs, kinetic energy")) {
            double gamma = Double.parseDouble(row.at().get(0)) / 2;
            double omega = Math.sqrt(STIFFNESS - gamma * gamma);
            long turns = (long) Math.floor(5 * omega / Math.PI);
            double expected = (Math.exp(-gamma * turns * Math.PI / omega)
                    + Math.exp(-gamma * (turns - 1) * Math.PI / omega)) / 2;
            assertEquals(expected, row.measured().get(0), 4e-7 * expected, row.toString());
            assertEquals(2 * Math.PI / omega, row.measured().get(1), 2e-8, row.toString());
            // energy that is lost is work of the damper; the spring's work is the kinetic energy
            assertEquals(row.measured().get(4), row.measured().get(3), 1e-6, row.toString());
            assertEquals(SceneGrid.WHOLE, row.end());
        }
    }

    /** The order is the slope of log error over log deltaT; measured are 0.99 to 1.00, 1.93 to 2.00
     * and 3.91 to 4.00. */
    @ParameterizedTest
    @CsvSource({"symplectic-euler, 1", "verlet, 2", "implicit-midpoint, 2", "midpoint, 2", "rk4, 4", "yoshida4, 4"})
    void theErrorFallsByTheOrder(String solver, int order) {
        List<Row> rows = rows("02-one-spring.yaml", "deltaT = 0.02, 0.04, 0.08; solver = " + solver + "; "
                + "duration = 0.96", "error, evaluations, steps");
        for (int k = 1; k < rows.size(); k++) {
            double slope = Math.log(rows.get(k).measured().get(0) / rows.get(k - 1).measured().get(0)) / Math.log(2);
            assertEquals(order, slope, 0.1, solver);
            assertTrue(rows.get(k).measured().get(1) < 0.05 * rows.get(k).measured().get(0),
                    "the reference is converged: " + rows.get(k));
            assertEquals(rows.get(k - 1).measured().get(3) / 2.0, rows.get(k).measured().get(3), 1);
        }
    }

    /** A ball from 1 m is down after sqrt(2/g); each bounce keeps the square of the restitution of the energy. */
    @Test
    void aBallBouncesWhenItIsDown() {
        for (Row row : rows("06-bouncing-ball.yaml", "rules.ground.restitution = 0.2, 0.5, 0.8; duration = 0.6",
                "first impact, impacts, work of impacts, work of gravity")) {
            double restitution = Double.parseDouble(row.at().get(0));
            assertEquals(Math.sqrt(2 / 9.81), row.measured().get(0), 1e-9);
            assertEquals(1, row.measured().get(1));
            assertEquals(-9.81 * (1 - restitution * restitution), row.measured().get(2), 1e-8);
        }
    }

    /** omega deltaT may be 2 for verlet; an undamped spring of scene 2. */
    @Test
    void theLongestStableStepFallsWithTheRootOfTheStiffness() {
        for (Row row : rows("03-damped-spring.yaml",
                "springs[0].stiffness = 25, 100, 400; springs[0].damping = 0; solver = verlet",
                "longest stable deltaT")) {
            assertEquals(2 / Math.sqrt(Double.parseDouble(row.at().get(0))), row.measured().get(0), 1e-5);
        }
    }

    @Test
    void aRunThatFailsIsARowWithItsReason() {
        Row row = rows("12-stiff-network.yaml", "deltaT = 0.01", "evaluations, max y of load").get(0);
        assertTrue(row.measured().stream().allMatch(value -> value.isNaN()), row.toString());
        assertTrue(row.end().startsWith("the numerical error is"), row.end());
    }

    /** A body thrown upwards turns after v/g, here at the end of a step, at v^2/(2 g). */
    @ParameterizedTest
    @CsvSource({"verlet, 10, 0.01", "rk4, 10, 0.01", "verlet, 2, 0.05", "rk4, 2, 0.05"})
    void aTurningPointMayBeTheEndOfAStep(String solver, double gravity, String deltaT) throws IOException {
        Row row = rowsOf("""
                title: A test
                teaches: A test.
                duration: 0.2
                particles:
                  - {id: a, position: [0, 0, 0], velocity: [0, 0.1, 0]}
                effects:
                  - gravity: {acceleration: [0, -%s, 0]}
                """.formatted(gravity), "solver = " + solver + "; deltaT = " + deltaT,
                "max y of a, min y of a, y of a").get(0);
        assertEquals(0.1 * 0.1 / (2 * gravity), row.measured().get(0), 1e-15, row.toString());
        assertEquals(row.measured().get(2), row.measured().get(1), row.toString());
    }

    /** The first particle leaves at t = 0.5 s, and the second moves up in the state. */
    @Test
    void aParticleIsFollowedWhenOthersAreGone() throws IOException {
        Row row = rowsOf("""
                title: A test
                teaches: A test.
                solver: rk4
                duration: 1
                particles:
                  - {id: a, position: [0, 0, 0], velocity: [2, 0, 0]}
                  - {id: b, position: [0, 0, 0], velocity: [-1, 0, 0]}
                rules:
                  - kill: {point: [0.995, 0, 0], normal: [-1, 0, 0]}
                """, "deltaT = 0.01", "x of b, max x of b, x of a, max x of a").get(0);
        assertEquals(-1, row.measured().get(0), 1e-12, row.toString());
        assertEquals(0, row.measured().get(1), row.toString());
        assertEquals(Double.NaN, row.measured().get(2), row.toString());
        assertEquals(1, row.measured().get(3), 1e-12, row.toString());
        assertEquals(SceneGrid.WHOLE, row.end());
    }

    @Test
    void aPointWithoutTheParticleIsARowWithItsReason() {
        List<Row> rows = rows("08-cloth.yaml", "shapes[0].columns = 25, 13; duration = 0.01",
                "y of cloth[20,2], steps");
        assertEquals(SceneGrid.WHOLE, rows.get(0).end());
        assertEquals(List.of(Double.NaN, Double.NaN), rows.get(1).measured());
        assertEquals("particle 'cloth[20,2]' does not exist", rows.get(1).end());
    }

    @Test
    void rangesHaveTheirValues() {
        assertEquals(List.of("0", "0.1", "0.2", "0.3"), GridAxis.list("k = 0 .. 0.35 by 0.1").get(0).values());
        assertEquals(List.of("3", "1", "-1"), GridAxis.list("k = 3 .. -2 by -2").get(0).values());
        assertEquals(List.of("0.001", "0.00316228", "0.01", "0.0316228", "0.1"),
                GridAxis.list("k = 1e-3..1e-1 log 5").get(0).values());
        assertEquals(List.of("1.2345678", "3.51364", "10.000001"),
                GridAxis.list("k = 1.2345678 .. 10.000001 log 3").get(0).values(), "ends keep their digits");
        assertEquals(List.of("[0, -9.81, 0]", "[0, 0, 0]"), GridAxis.list("g = [0, -9.81, 0], [0, 0, 0]").get(0)
                .values());
        assertEquals(List.of(List.of("1", "3"), List.of("1", "4"), List.of("2", "3"), List.of("2", "4")),
                new Grid(GridAxis.list("a = 1, 2; b = 3, 4")).points());
    }

    @Test
    void aChartHasACurveForSomeOfManyValues() {
        Grid grid = new Grid(GridAxis.list("duration = 1, 2; springs[0].damping = 0 .. 98 by 1"));
        List<Measure> measures = Measure.list("steps");
        List<Row> rows = grid.points().stream().map(point -> new Row(point, List.of(1.0), SceneGrid.WHOLE)).toList();
        List<String> names = new GridCharts(grid, measures, rows).panels(measures.get(0), "").get(0).charts().get(0)
                .series().stream().map(Series::name).toList();
        assertEquals(List.of("damping = 0", "damping = 14", "damping = 28", "damping = 42", "damping = 56",
                "damping = 70", "damping = 84", "damping = 98"), names);
    }
}
