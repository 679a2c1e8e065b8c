package particles.experiments.phase;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import particles.experiments.phase.PhasePortraits.Portrait;
import particles.experiments.phase.PhasePortraits.Portraits;
import particles.experiments.runs.SolverChoice;
import particles.scene.TestScenes;
import particles.scene.format.SceneDescription;
import particles.view.Chart;
import particles.view.Look;
import particles.view.Series;
import particles.view.Series.Mark;

class PhasePortraitsTest {
    private static final SceneDescription SPIRAL = TestScenes.named("11-euler-spiral");

    private static Portraits compare(SceneDescription scene, String solvers) {
        return compare(scene, solvers, "block", Optional.of(Coordinate.X), Optional.empty());
    }

    private static Portraits compare(SceneDescription scene, String solvers, String particle, Optional<Coordinate> axis,
            Optional<String> about) {
        return PhasePortraits.compare(scene, SolverChoice.list(solvers), particle, axis, about,
                (part, what) -> { });
    }

    /**
     * The reference stays on the unit circle and returns after three periods; Euler's path ends three times as far out.
     */
    @Test
    void eachSolverIsOverTheReferenceInAChartOfItsOwn() {
        Portraits portraits = compare(SPIRAL, "euler,symplectic-euler,rk4");
        assertEquals(List.of("euler", "symplectic-euler", "rk4"),
                portraits.portraits().stream().map(Portrait::solver).toList());
        for (Portrait portrait : portraits.portraits()) {
            Series reference = portrait.chart().series().get(0);
            assertEquals(Mark.BAND, reference.mark());
            for (int k = 0; k < reference.x().length; k++) {
                assertEquals(1, Math.hypot(reference.x()[k], reference.y()[k]), 1e-8);      // measured 6e-10
            }
            Series path = portrait.chart().series().get(1);
            assertEquals(portrait.solver(), path.name());
            assertEquals(162, path.x().length, "the start and 161 steps");
        }
        List<Object> euler = portraits.table().rows().get(0);
        assertEquals(3, Math.hypot((Double) euler.get(3), (Double) euler.get(4)), 0.02);
        double reference = (Double) portraits.table().rows().get(3).get(3);
        assertEquals(StrictMath.cos(161 * 0.11737), reference, 1e-8);
        assertTrue((Double) portraits.table().rows().get(2).get(5) < 1e-3, "rk4");
    }

    /**
     * Euler's last state is 3.01 from the centre of the unit circle. Symplectic Euler moves on the ellipse x^2 - h x v
     * + v^2 = 1 with h = 0.117, whose farthest point from the circle is at 1 / sqrt(1 - h / 2): 3.07 % off; measured a
     * little more, since the start is at the beginning of a step.
     */
    @Test
    void pathsAreMeasuredAgainstTheCurve() {
        List<Portrait> portraits = compare(SPIRAL, "euler,symplectic-euler,rk4").portraits();
        assertEquals(2.0, portraits.get(0).off(), 0.01);
        assertEquals(0.0307, portraits.get(1).off(), 0.0015);
        assertTrue(portraits.get(2).off() < 3e-6, "rk4: measured 1.9e-6, and not " + portraits.get(2).off());
    }

    @Test
    void whatFliesAwayIsMarked() {
        List<Portrait> portraits = compare(SPIRAL.withDeltaT(1).withDuration(12), "euler").portraits();
        List<Series> series = portraits.get(0).chart().series();
        assertEquals(Mark.FAILURES, series.get(4).mark());
        assertTrue(series.get(1).x().length < 13, "it is drawn as far as the picture goes");
        assertTrue(portraits.get(0).whole(), "but the run came to its end");
        List<Portrait> longer = compare(SPIRAL.withDeltaT(2).withDuration(200), "euler").portraits();
        assertFalse(longer.get(0).whole());
        assertEquals("off the reference by more than 10 times its half width", longer.get(0).answer());
        assertEquals("off the reference by 200 % of its half width", compare(SPIRAL, "euler").portraits().get(0)
                .answer());
    }

    @Test
    void withoutAnAxisAParticleIsSeenAlongItsWidest() {
        SceneDescription ball = TestScenes.named("06-bouncing-ball").withSolver("rk4").withDuration(0.5);
        Portrait widest = compare(ball, "rk4", "ball", Optional.empty(), Optional.empty()).portraits().get(0);
        assertEquals(Coordinate.Y, widest.axis());
        Portrait still = compare(ball, "rk4", "ball", Optional.of(Coordinate.Z), Optional.empty()).portraits().get(0);
        assertTrue(Double.isNaN(still.off()), "nothing moves along z, and there is no curve");
        assertEquals("", still.answer());
    }

    /** A square of side 2, and points in it, on it and off it, half its width being 1. */
    @Test
    void distancesAreFromTheNearestLine() {
        CurveDistance square = new CurveDistance(path(-1, -10, 1, -10, 1, 10, -1, 10, -1, -10));
        assertEquals(0.5, square.largest(path(0.5, 0)), 1e-15);
        assertEquals(0, square.largest(path(1, 3)), 1e-15);
        assertEquals(5, square.largest(path(4, 50, 0.5, 0)), 1e-15);            // 3 and 4 from a corner
        assertEquals(4, square.outwards(4, 20), 1e-15);
        assertTrue(new CurveDistance(path(1, 0, 1, 0)).isDegenerate());
    }

    private static Series path(double... points) {
        return Series.of(Look.OWN, "", Mark.LINE, IntStream.range(0, points.length / 2).mapToObj(k ->
                Arrays.copyOfRange(points, 2 * k, 2 * k + 2)).toList());
    }

    @Test
    void aSceneMayShowAnAngleAboutAnotherParticle() {
        SceneDescription pendulum = TestScenes.named("41-double-pendulum").withSolver("rk4").withDuration(1);
        Portraits portraits = compare(pendulum, "rk4", "hand", Optional.of(Coordinate.ANGLE), Optional.of("elbow"));
        Chart chart = portraits.portraits().get(0).chart();
        assertEquals("angle theta of 'hand' (rad)", chart.x().label());
        assertEquals("angular velocity omega (rad/s)", chart.y().label());
        assertEquals(2 * Math.PI / 3, chart.series().get(1).x()[0], 1e-7);      // 120 degrees from hanging down
        assertEquals(0, chart.series().get(1).y()[0]);
        assertTrue(portraits.table().columns().stream().anyMatch(column -> column.name().equals("angle (rad)")));
    }
}
