package particles.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static particles.Texts.assertHas;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import particles.spec.messages.InvalidInputException;
import particles.view.ParticleStyle.ParticleMark;
import particles.view.RenderOptions;

/** Balls of a scene have the radius that it gives them, in the law of repulsion and in pictures. */
class BallsInScenesTest {
    private static final String BALLS = """
            title: Balls
            teaches: how large balls are
            solver: rk4
            deltaT: 0.01
            duration: 1
            particles:
              - {id: small, position: [0, 0, 0]}
              - {id: large, position: [1, 0, 0], radius: 0.8}
            shapes:
              - rope: {id: row, start: [5, 0, 0], end: [6, 0, 0], particles: 2, mass: 1, radius: 0.6}
            """;
    private static final String REPULSION = "effects:\n  - repulsion: {radius: 0.3, stiffness: 10}\n";

    private static ParticleMark mark(String id, int colour, double radius) {
        return new ParticleMark(id, colour < 0 ? Optional.empty() : Optional.of(colour), radius, "");
    }

    private static RenderOptions look(String text) {
        return TestScenes.read(text).drawing().look();
    }

    @Test
    void ownRadiiCountInTheLaw() {
        Scene scene = TestScenes.build(BALLS + REPULSION);
        double energy = scene.system().getEffects().get(0).getPotentialEnergy(scene.system().getOwnState(), 0);
        assertEquals(10 * (0.1 * 0.1 + 0.2 * 0.2) / 2, energy, 1e-14);
    }

    @Test
    void ballsAreDrawnWithTheirRadius() {
        RenderOptions look = look(BALLS + REPULSION);
        assertEquals(0.3, look.particleRadius());
        assertEquals(List.of(mark("large", -1, 0.8), mark("row[0]", -1, 0.6), mark("row[1]", -1, 0.6)),
                look.style().marks());
    }

    /** What the look says goes first; a mark without a radius leaves the ball its own. */
    @Test
    void theLookOverridesRadii() {
        RenderOptions look = look(BALLS + REPULSION + """
                look:
                  particleRadius: 0.1
                  marks:
                    - {particle: row, colour: "#0000ff"}
                    - {particle: large, radius: 0.2}
                """);
        assertEquals(0.1, look.particleRadius());
        assertEquals(List.of(mark("large", -1, 0.2), mark("row[0]", 255, 0.6), mark("row[1]", 255, 0.6)),
                look.style().marks());
        assertHas(assertThrows(InvalidInputException.class, () -> look(BALLS + "look: {marks: [{particle: rows}]}\n"))
                .getMessage(), "unknown particle 'rows'; did you mean 'row'?");
    }

    @Test
    void withoutRepulsionNoRadiusIsSet() {
        assertEquals(0, look(BALLS).particleRadius());
    }
}
