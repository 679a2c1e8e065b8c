package particles.effects;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import deSolvers.catalog.SolverCatalog;
import deSolvers.catalog.SolverInfo;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import particles.energy.EnergyRecorder;
import particles.energy.Resolution;
import particles.experiments.phase.Coordinate;
import particles.experiments.phase.PhasePortraits;
import particles.experiments.runs.SolverChoice;
import particles.scene.Scene;
import particles.scene.SceneBuilder;
import particles.scene.ShortRun;
import particles.scene.TestScenes;

/**
 * Forces that act for less time than a step, beside what FastPassagesTest and GrazingPassagesTest measure. Reference
 * values were computed by 40,000 RK4 steps from the edge of the force; half as many differ by less than 1e-7.
 */
class BriefForcesTest {

    private static Stream<String> solvers(boolean adaptive) {
        return SolverCatalog.all().stream().filter(info -> info.adaptive() == adaptive).map(SolverInfo::name);
    }

    private static Stream<String> adaptive() {
        return solvers(true);
    }

    private static Stream<String> fixed() {
        return solvers(false);
    }

    /** A particle passes a soft post of which the way through takes 0.016 s. */
    private static ShortRun post(String solver, double deltaT, double x) {
        return new ShortRun(solver + " exact " + deltaT + " 1", """
                particles: [{id: b, position: [%s, 0.01, 0], velocity: [10, 0, 0]}]
                effects: [penaltySphere: {centre: [0, 0, 0], radius: 0.08, stiffness: 20000}]
                """.formatted(x));
    }

    private static ShortRun pair(String solver, String a, String b, String law) {
        return ShortRun.of(solver + " exact 0.04 1",
                "particles: [{id: a, %s}, {id: b, position: [1, 0, 0], %s}]\neffects: [%s]\n".formatted(a, b, law));
    }

    @ParameterizedTest
    @MethodSource("adaptive")
    void cohesionTurnsAPair(String solver) {
        ShortRun run = pair(solver, "position: [-1, 0.02, 0], velocity: [5, 0, 0]", "velocity: [-5, 0, 0]",
                "cohesion: {range: 0.1, depth: 1}");
        assertEquals(0, Math.hypot(run.at(3) - 3.39445897, run.at(4) - 3.67119168), 1e-4, solver);
    }

    /** Where both fly along, the speed is relative: nothing is passed, and no step is shortened. */
    @Test
    void ballsThatFlyTogetherAreNotSlowedDown() {
        ShortRun run = pair("dormand-prince", "position: [0, 0.01, 0], velocity: [1000, 0, 0]",
                "velocity: [1000, 0, 0]", "repulsion: {radius: 0.05, stiffness: 1e6}");
        assertTrue(run.getSystem().getEvaluations() < 200, run.getSystem().getEvaluations() + " evaluations");
    }

    private static Optional<Resolution.Brief> brief(ShortRun run) {
        EnergyRecorder recorder = new EnergyRecorder(run.getSimulation(), 1, 1);
        recorder.attachTo(run.getSimulation(), List.of());
        run.run();
        return recorder.getBrief();
    }

    /** 10 m/s cross 0.16 m in 0.016 s: at the nearest step on the way, 0.2 m from the centre, within 0.028 s. */
    @Test
    void aFixedStepThatSkipsAPostIsReported() {
        Resolution.Brief brief = brief(post("verlet", 0.04, -1)).orElseThrow();
        assertEquals("penaltySphere", brief.name());
        assertEquals(0.028, brief.time(), 1e-3);
    }

    /** Steps of 1 ms are 4 in the 0.005 s in which it may be inside and out, however it turns. */
    @ParameterizedTest
    @MethodSource("fixed")
    void aFixedStepThatResolvesThePostIsNot(String solver) {
        assertFalse(brief(post(solver, 0.001, -1)).isPresent(), solver);
    }

    @Test
    void theReferenceOfPhasePortraitsHitsThePost() {
        for (int start = 0; start < 10; start++) {
            double x = -1 - 0.037 * start;
            List<List<Object>> rows = PhasePortraits.compare(post("rk4", 0.04, x).getScene().description(),
                    SolverChoice.list("verlet"), "b", Optional.of(Coordinate.X), Optional.empty(),
                    (part, what) -> { }).table().rows();
            double late = 3.9436045 * 0.0037 * start;
            assertEquals(3.53320696 - late, (Double) rows.get(1).get(1), 1e-6, "the reference; measured 1e-7");
            assertTrue((Double) rows.get(0).get(3) > 5, "verlet passes, or is thrown farther");
        }
    }

    /** An orbit, springs and gravity have no such force; then the solver's sub-steps are its own. */
    @Test
    void mostScenesHaveNone() {
        for (String name : List.of("02-one-spring", "05-hanging-chain", "11-euler-spiral")) {
            Scene scene = SceneBuilder.build(TestScenes.named(name).withDuration(0.1));
            scene.simulation().run();
            assertEquals(Double.POSITIVE_INFINITY,
                    scene.system().getShortestTime(scene.system().getOwnState(), 0), name);
        }
    }
}
