package particles.experiments;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import particles.ChartData;
import particles.experiments.PhasePortraits.Portraits;
import particles.scene.SceneDescription;
import particles.scene.SceneReader;

class PhasePortraitsTest {
    private static final SceneDescription SPIRAL = SceneReader.read(Path.of("scenes/11-euler-spiral.yaml"));

    private static Portraits compare(SceneDescription scene, String solvers) {
        return PhasePortraits.compare(scene, SolverChoice.list(solvers), List.of("block"), List.of(Axis.X), (part, what) -> { });
    }

    /** The reference stays on the unit circle and returns after three periods; Euler's path ends three times as far out. */
    @Test
    void pathsLieOverTheReference() {
        Portraits portraits = compare(SPIRAL, "euler,rk4");
        List<ChartData.Series> series = portraits.charts().get(0).series();
        assertEquals(List.of("euler", "rk4"), series.subList(0, 2).stream().map(ChartData.Series::name).toList());
        ChartData.Series reference = series.get(2);
        for (int k = 0; k < reference.x().length; k++) {
            assertEquals(1, Math.hypot(reference.x()[k], reference.y()[k]), 1e-8);      // measured 6e-10
        }
        List<Object> euler = portraits.table().rows().get(0);
        assertEquals(3, Math.hypot((Double) euler.get(3), (Double) euler.get(4)), 0.02);
        assertEquals(1, (Double) portraits.table().rows().get(2).get(3), 1e-8);
        assertTrue((Double) portraits.table().rows().get(1).get(5) < 1e-3, "rk4");
    }

    @Test
    void whatFliesAwayIsMarked() {
        Portraits portraits = compare(SPIRAL.solvedBy("euler", Optional.empty(), 1, 12), "euler");
        List<ChartData.Series> series = portraits.charts().get(0).series();
        assertEquals(ChartData.Mark.FAILURES, series.get(2).mark());
        assertTrue(series.get(0).x().length < 13, "it is drawn as far as the picture goes");
    }
}
