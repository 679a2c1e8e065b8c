package particles.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import particles.law.Particles;

/** Scenes with rods and wires do what their texts say; a scene without them builds none. */
class ConstraintScenesTest {

    private static Scene scene(String file) {
        return SceneBuilder.build(SceneReader.read(Path.of("scenes", file)));
    }

    /** Every bead is on its wire at the end, within 7e-6 m, and the energy is that of the start. */
    @Test
    void beadsStayOnTheirWires() {
        Scene scene = scene("42-bead-on-a-wire.yaml");
        double before = scene.system().getEnergy(scene.system().getOwnState(), 0);
        scene.simulation().run();
        double[] state = scene.system().getOwnState();
        assertEquals(0.5 * Math.sin(Math.PI * state[0]), state[1], 4e-5);
        assertEquals(1, (state[6] - 1.5) * (state[6] - 1.5) + (state[7] - 2.5) * (state[7] - 2.5), 1e-5);
        assertEquals((state[12] + 2.5) * (state[12] + 2.5) / 2, state[13] - 1.8, 1e-5);
        assertEquals(before, scene.system().getEnergy(state, 0), 5e-3, "of 30 J in motion; measured: 1.8e-3");
    }

    @Test
    void theRodComesToRestOnTheGround() {
        Scene scene = scene("43-rod-on-the-ground.yaml");
        scene.simulation().run();
        double[] state = scene.system().getOwnState();
        for (int i = 0; i < 12; i += Particles.STRIDE) {
            assertEquals(0, state[i + 1], 1e-9);
            assertEquals(0, Math.abs(state[i + 3]) + Math.abs(state[i + 4]), 1e-9);
        }
        assertEquals(1, state[6] - state[0], 1e-7);
    }
}
