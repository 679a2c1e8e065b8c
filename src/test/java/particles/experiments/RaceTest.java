package particles.experiments;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import particles.ChartData;
import particles.ChartData.Mark;
import particles.DataTable;
import particles.experiments.Race.Lane;
import particles.experiments.Race.Result;
import particles.scene.SceneDescription;
import particles.scene.SceneReader;

class RaceTest {
    private static final SceneDescription SPIRAL = SceneReader.read(Path.of("scenes/11-euler-spiral.yaml"));
    private static final SceneDescription CHAIN = SceneReader.read(Path.of("scenes/16-soft-chain.yaml"));
    private static final Race.Audience NOBODY = (scene, solver, extent) -> List.of();

    private static SceneDescription lasting(SceneDescription scene, double duration) {
        return scene.solvedBy("rk4", Optional.empty(), scene.deltaT(), duration);
    }

    private static Result run(SceneDescription scene, String solvers, int frames, Race.Audience audience) {
        return new Race(scene, SolverChoice.list(solvers), frames).run(audience, (part, what) -> { });
    }

    @Test
    void evaluationsDifferByLessThanAStep() {
        Result race = run(lasting(CHAIN, 3), "midpoint, rk4, adams, verlet, yoshida4, dormand-prince", 30, NOBODY);
        assertFalse(race.equalTime());
        assertEquals(300, race.work());                             // 75 steps of rk4
        for (Lane lane : race.lanes()) {
            long evaluations = lane.drift().outcome().evaluations();
            assertEquals(lane.match().evaluations(), evaluations, "what was measured is what ran");
            assertTrue(Math.abs(evaluations - 300) < lane.match().aStep(),
                    lane.match().setting().solver().label() + ": " + evaluations + ", a step has " + lane.match().aStep());
        }
        assertTrue(RaceCharts.title(race).contains("equal work, 300 evaluations each"), RaceCharts.title(race));
    }

    @Test
    void allPanelsHaveTheSameFrameTimes() {
        Result race = run(lasting(CHAIN, 3), "midpoint, rk4, verlet, dormand-prince", 37, NOBODY);
        assertEquals(38, race.times().length);
        for (int k = 0; k <= 37; k++) {
            assertEquals(k * 3 / 37.0, race.times()[k], 1e-15 * 3);
        }
        assertEquals(38, race.reference().size());
        race.lanes().forEach(lane -> assertEquals(38, lane.states().size(), lane.match().setting().solver().label()));
    }

    /** x = cos t, v = -sin t; between the reference's sub-steps the motion is a cubic. */
    @Test
    void referenceIsTheExactMotion() {
        Result race = run(lasting(SPIRAL, 10), "rk4, midpoint", 77, NOBODY);
        Lane midpoint = race.lanes().get(1);
        double worst = 0;
        for (int k = 0; k < race.times().length; k++) {
            double x = race.reference().get(k)[6];
            worst = Math.max(worst, Math.abs(x - StrictMath.cos(race.times()[k])));
            assertEquals(Math.abs(x - midpoint.states().get(k)[6]) / Math.sqrt(2), midpoint.distance()[k], 1e-15,
                    "root mean square over two particles, one of them fixed");
        }
        assertTrue(worst < 2e-6, "measured " + worst);             // 4.8e-7: h^4 / 384 of a cubic over h = 0.12
        assertTrue(midpoint.distance()[77] > 1e-3, "midpoint is not exact");
    }

    /** Who makes pictures sees, at the frames' times, what was measured: the ghost is the reference, bit for bit. */
    @Test
    void audienceSeesWhatIsMeasured() {
        List<Optional<SolverChoice>> order = new ArrayList<>();
        List<FrameStates> seen = new ArrayList<>();
        SceneDescription scene = lasting(CHAIN, 2);
        Result race = run(scene, "euler, rk4", 20, (built, solver, extent) -> {
            order.add(solver);
            FrameStates states = new FrameStates(20 / scene.duration());
            seen.add(states);
            return List.of(states);
        });
        assertTrue(order.get(0).isEmpty(), "the reference comes first");
        assertEquals(List.of("euler", "rk4"), order.subList(1,
                3).stream().map(solver -> solver.orElseThrow().label()).toList());
        for (int k = 0; k < 3; k++) {
            List<double[]> measured = k == 0 ? race.reference() : race.lanes().get(k - 1).states();
            assertEquals(21, measured.size());
            for (int f = 0; f < 21; f++) {
                assertArrayEquals(measured.get(f), seen.get(k).states().get(f));
            }
        }
    }

    @Test
    void whoLeavesIsShownAsSuch() {
        Result race = run(lasting(CHAIN, 4), "euler, verlet", 40, NOBODY);
        Lane euler = race.lanes().get(0);
        double left = euler.left().orElseThrow();
        assertTrue(left > 1 && left < 4, "left at " + left);
        assertEquals((int) (left * 10) + 1, euler.states().size(), "frames until then");
        assertTrue(race.lanes().get(1).left().isEmpty());
        String finding = RaceCharts.finding(race);
        assertTrue(finding.startsWith("verlet stays nearest") && finding.contains("euler leaves at t = "), finding);
        for (ChartData chart : List.of(RaceCharts.distance(race), RaceCharts.energy(race))) {
            ChartData.Series crosses = chart.series().get(2);
            assertEquals(Mark.FAILURES, crosses.mark());
            assertEquals(left, crosses.x()[0], 0.1, "within a frame");
        }
        DataTable table = RaceCharts.table(race);
        assertEquals(left, table.rows().get(0).get(8));
        assertTrue(table.rows().get(0).get(9).toString().contains("went where the reference never comes near"));
    }

    /** By a clock on which a step takes a microsecond for each evaluation and two for itself. */
    @Test
    void implicitSolversGetEqualTime() {
        Race race = new Race(lasting(CHAIN, 3), SolverChoice.list("rk4, implicit-midpoint, verlet"), 10,
                outcome -> 1e-6 * (outcome.evaluations() + 2 * outcome.steps()));
        Result result = race.run(NOBODY, (part, what) -> { });
        assertTrue(result.equalTime());
        assertEquals(450e-6, result.work(), 1e-12, "rk4: 75 steps of 4 + 2");
        for (Lane lane : result.lanes()) {
            assertEquals(450e-6, lane.match().seconds(), Math.max(lane.match().aStep(), 0.02 * 450e-6),
                    lane.match().setting().solver().label());
        }
        assertEquals(150, Math.round(3 / result.lanes().get(2).match().setting().deltaT()), 1.5, "verlet: steps of 1 + 2");
        assertTrue(RaceCharts.title(result).contains("equal time, 0.450 ms each"), RaceCharts.title(result));
    }
}
