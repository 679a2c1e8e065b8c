package particles.experiments.phase;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Texts.assertStarts;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import particles.experiments.phase.PhasePortraits.Portrait;
import particles.experiments.phase.PhasePortraits.Portraits;
import particles.experiments.runs.SolverChoice;
import particles.scene.TestScenes;
import particles.scene.format.SceneDescription;
import particles.view.Chart;
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
        assertEquals(3, Math.hypot((Double) euler.get(1), (Double) euler.get(2)), 0.02);
        double reference = (Double) portraits.table().rows().get(3).get(1);
        assertEquals(StrictMath.cos(161 * 0.11737), reference, 1e-8);
        assertTrue((Double) portraits.table().rows().get(2).get(3) < 1e-3, "rk4");
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
        assertStarts(longer.get(0).answer(), "stopped at ");
        assertEquals("2.01 m off at the end", compare(SPIRAL, "euler").portraits().get(0).answer());
    }

    @Test
    void withoutAnAxisAParticleIsSeenAlongItsWidest() {
        SceneDescription ball = TestScenes.named("06-bouncing-ball").withSolver("rk4").withDuration(0.5);
        Portrait widest = compare(ball, "rk4", "ball", Optional.empty(), Optional.empty()).portraits().get(0);
        assertEquals(Coordinate.Y, widest.axis());
        Portrait still = compare(ball, "rk4", "ball", Optional.of(Coordinate.Z), Optional.empty()).portraits().get(0);
        assertEquals(still.exact().x().length, still.chart().series().get(0).x().length, "nothing moves along z");
        assertEquals("0 m off at the end", still.answer());
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
        assertTrue(portraits.table().columns().stream().anyMatch(column -> column.name().equals("angle theta (rad)")));
    }
}
