package particles.messages;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import particles.SimulationException;
import particles.scene.format.Overrides;
import particles.scene.Scene;
import particles.scene.SceneBuilder;
import particles.scene.SceneReader;

/** Friction is named only where it is why a solver finds no step. */
class FrictionMessageTest {
    private static Scene jelly(Overrides overrides) {
        return SceneBuilder.build(SceneReader.read(Path.of("scenes", "10-jelly-block.yaml")),
                overrides.with("duration", "0.6", "--duration"));
    }

    /** Both failed here before friction acted as an impulse in the step in which it stops a particle. */
    @ParameterizedTest
    @ValueSource(strings = {"verlet", "implicit-midpoint"})
    @Tag("slow")
    void frictionOnARestingJellyEndsNoRun(String solver) {
        Scene scene = jelly(new Overrides().with("solver", solver, "--solver"));
        scene.simulation().run();
        assertEquals(0.6, scene.system().getTime(), 1e-9);
    }

    /** A failure that is not the solver's has another line. */
    @Test
    void otherFailuresAreNotFrictions() {
        Scene scene = jelly(new Overrides());
        SimulationException e = new SimulationException(0, -1, "the clock does not move", null);
        assertTrue(FrictionMessage.of(scene, name -> "--" + name, e).isEmpty());
    }
}
