package particles.messages;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import particles.SimulationException;
import particles.scene.Scene;
import particles.scene.SceneBuilder;
import particles.scene.TestScenes;

/** Friction is named only where it is why a solver finds no step. */
class FrictionMessageTest {
    private static Scene jelly(String solver) {
        return SceneBuilder.build(TestScenes.named("10-jelly-block").withSolver(solver).withDuration(0.6));
    }

    /** Both failed here before friction acted as an impulse in the step in which it stops a particle. */
    @ParameterizedTest
    @ValueSource(strings = {"verlet", "implicit-midpoint"})
    @Tag("slow")
    void frictionOnARestingJellyEndsNoRun(String solver) {
        Scene scene = jelly(solver);
        scene.simulation().run();
        assertEquals(0.6, scene.system().getTime(), 1e-9);
    }

    /**
     * With exact impacts, springs pull particles of a rope on a rough ball past a stop, where friction turns within a
     * billionth of the step and Newton's method finds no solution.
     */
    @Test
    void frictionThatTurnsTooFastIsNamedWithWhatHelps() {
        Scene scene = rope("backward-euler");
        SimulationException e = assertThrows(SimulationException.class, scene.simulation()::run);
        String message = FrictionMessage.of(scene, name -> "--" + name, e).orElseThrow();
        assertTrue(message.matches("backward-euler stopped at t = 0\\.\\d+ s: Newton's iteration did not converge: .*"
                + "\nsomething is about to stop or to begin to slide, and there Coulomb friction changes its"
                + " direction too"
                + " fast for backward-euler\n"
                + "try --solver=rk4, which steps across the change"), message);
        Scene asAdvised = rope("rk4");
        asAdvised.simulation().run();
        assertEquals(0.6, asAdvised.system().getTime(), 1e-12);
    }

    private static Scene rope(String solver) {
        return SceneBuilder.build(TestScenes.read(ROPE).withSolver(solver));
    }

    private static final String ROPE = """
            title: A rope over a rough ball
            teaches: Friction on what is elastic.
            solver: rk4
            deltaT: 0.005
            duration: 0.6
            impact: exact
            shapes:
              - rope: {start: [-0.6, 0.6, 0.02], end: [0.7, 0.6, 0.02], particles: 12, totalMass: 0.2,
                       structural: {stiffness: 200, damping: 0.1}}
            effects:
              - gravity
            rules:
              - sphere: {centre: [0, 0, 0], radius: 0.55, restitution: 0.2, friction: {law: coulomb, coefficient: 0.4}}
            """;

    /** A failure that is not the solver's has another line. */
    @Test
    void otherFailuresAreNotFrictions() {
        Scene scene = jelly("rk4");
        SimulationException e = new SimulationException(0, -1, "the clock does not move", null);
        assertTrue(FrictionMessage.of(scene, name -> "--" + name, e).isEmpty());
    }
}
