package particles.app.run;

import static deSolvers.problems.Bounds.assertAbove;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Systems.onMove;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import particles.app.student.StudentClasses;
import particles.law.Particles;
import particles.law.Vector3;
import particles.output.raster.CameraProjection;
import particles.scene.Scene;
import particles.scene.SceneBuilder;
import particles.scene.SceneReader;
import particles.scene.TestScenes;
import particles.scene.format.SceneDescription;

/** Cameras for scenes that name none. */
class CameraFinderTest {
    private static final int WIDTH = 960;
    private static final int HEIGHT = 540;

    private static final SceneDescription CHAIN = TestScenes.named("16-soft-chain");

    private static CameraProjection view(SceneDescription scene) {
        return new CameraProjection(CameraFinder.find(scene), WIDTH, HEIGHT);
    }

    /** The height of the chain at the start, in pixels. */
    private static double size(CameraProjection view, Scene scene) {
        double[] state = scene.system().getOwnState();
        int end = scene.system().getStateSize() - Particles.STRIDE;
        return y(view, state, end) - y(view, state, 0);
    }

    private static double y(CameraProjection view, double[] state, int x) {
        return view.place(Vector3.at(state, x)).y();
    }

    /** Ten pixels, when the camera was fitted to all that was seen until the energy was out of bounds. */
    @ParameterizedTest
    @ValueSource(strings = {"euler", "midpoint", "verlet", "adams"})
    void aRunThatBlowsUpIsSeenFromNearby(String solver) {
        SceneDescription chain = CHAIN.withSolver(solver).withDeltaT(0.2);
        double size = size(view(chain), SceneBuilder.build(chain));
        assertAbove(HEIGHT / 8.0, size, solver);
    }

    @Test
    void aRunThatFailsBeforeItsFirstStepIsSeenWhereItBegins() {
        SceneDescription jam = TestScenes.read("""
                title: a jam
                teaches: friction of 4 jams a rod
                solver: rk4
                deltaT: 0.001
                duration: 0.02
                impact: exact
                particles:
                  - {id: a, position: [0, 0, 0], velocity: [3, 0, 0]}
                  - {id: b, position: [-0.57735026919, 0.81649658093, 0], velocity: [3, 0, 0]}
                rods: [{from: a, to: b}]
                effects: [gravity]
                rules:
                  - ground: {restitution: 0, restSpeed: 0.000001, friction: {law: coulomb, coefficient: 4}}
                """);
        assertTrue(Math.abs(size(view(jam), SceneBuilder.build(jam))) > HEIGHT / 8.0);
    }

    @Test
    void aRunThatDoesNotBlowUpStaysInThePicture() {
        Scene scene = SceneBuilder.build(CHAIN);
        CameraProjection view = view(CHAIN);
        scene.simulation().addObserver(onMove(motion -> {
            double[] state = motion.getEndState();
            for (int x = 0; x < state.length; x += Particles.STRIDE) {
                assertTrue(view.isInPicture(Vector3.at(state, x)), "t = " + motion.getEndTime());
            }
        }));
        scene.simulation().run();
        assertTrue(size(view, scene) < HEIGHT);
    }

    private static final String PUSHED = """
            title: Pushed
            teaches: The energy scale knows nothing of a student's own force.
            solver: SOLVER
            deltaT: 0.01
            duration: DURATION
            particles:
              - {id: a, position: [0, 0, 0]}
              - {id: b, position: [0, 1, 0]}
            springs:
              - {from: a, to: b, stiffness: 1e4}
            effects:
              - particles.app.run.Push
            """;

    private static CameraProjection viewOfPushed(DoubleUnaryOperator strength, String solver, double duration) {
        SceneDescription described = SceneReader.read("pushed.yaml", PUSHED.replace("SOLVER", solver)
                .replace("DURATION", "" + duration).getBytes(StandardCharsets.UTF_8), new StudentClasses(),
                List.of());
        Push.strength = strength;
        Push.calls = 0;
        return view(described);
    }

    /** A push of t N does 1,250 J of work on each mass of 1 kg in 10 s; at the start nothing promises 0.1 J. */
    @Test
    void whatOwnForcesDoIsNoBlowUp() {
        assertTrue(viewOfPushed(t -> t, "rk4", 10).isInPicture(new Vector3(166, 0, 0)), "x = t^3/6");
    }

    /**
     * bulirsch-stoer takes 13.5 evaluations per step: 12 million of a particle are enough. The ledger makes 2.7 million
     * of its own beside them. 1.5 million steps, as many as are enough with rk4, would make 50 million.
     */
    @Test
    void aRehearsalWithADearSolverIsAsShortAsWithACheapOne() {
        viewOfPushed(t -> 1, "bulirsch-stoer", 20_000);
        assertEquals(1.47e7, Push.calls, 1e5, "evaluations times particles");
    }
}
