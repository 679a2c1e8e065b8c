package particles.scene;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.SimulationException;
import particles.spec.messages.InvalidInputException;

/** Particles with the same position: what has a direction there runs, the rest is refused with both names. */
class AtOnePlaceTest {
    private static String scene(String solver, String a, String b, String more) {
        return """
                title: At one place
                teaches: two particles there
                solver: %s
                deltaT: 0.01
                duration: 2
                particles:
                  - {id: a, %s}
                  - {id: b, %s}
                """.formatted(solver, a, b) + more;
    }

    private static String soft(String a, String b) {
        return scene("rk4", a, b, "effects: [repulsion: {radius: 0.1, stiffness: 100}]\n");
    }

    private static String spring(String solver, String keys) {
        return scene(solver, "position: [0, 0, 0], velocity: [1, 0, 0]", "position: [0, 0, 0]",
                "springs: [{from: a, to: b, stiffness: 100" + keys + "}]\n");
    }

    private static String refusal(String text) {
        return assertThrows(InvalidInputException.class, () -> TestScenes.build(text)).getMessage();
    }

    /** Whether at rest or not, and with zeros of both signs. */
    @ParameterizedTest
    @CsvSource(delimiter = ';', value = {
            "position: [0, 0, 0]; position: [0, 0, 0]",
            "position: [1, 2, 3]; position: [1, 2, 3], velocity: [1, 0, 0]",
            "position: [0, -0.0, 0]; position: [0, 0.0, 0], fixed: true",
            "position: [0, 0, 0], fixed: true; position: [0, 0, 0], velocity: [0, 5, 0]",
            "position: [1e-39, 0, 0]; position: [1e-39, 0, 0]",
            "position: [0.1, 0.2, 0.3], mass: 1e-6; position: [0.1, 0.2, 0.3], mass: 1e6",
    })
    void softBallsWithOneCentreAreRefused(String a, String b) {
        assertTrue(refusal(soft(a, b)).contains("x.yaml:9:11: 'a' and 'b' are at the same place; soft balls there"
                + " have no direction"), refusal(soft(a, b)));
    }

    /** Without softening. */
    @ParameterizedTest
    @CsvSource(delimiter = ';', value = {
            "gravitation: {}; 'a' and 'b' are at the same place; without softening",
            "attraction: {strength: 1}; 'a' is at the point that attracts it; without softening",
            "gravitation: {softening: 0.1}; ",
            "attraction: {strength: 1, softening: 0.1}; ",
    })
    void whatAttractsNeedsADirection(String effect, String refusal) {
        String text = scene("rk4", "position: [0, 0, 0]", "position: [0, 0, 0]", "effects: [" + effect + "]\n");
        if (refusal == null) {
            assertDoesNotThrow(() -> TestScenes.build(text));
        } else {
            assertTrue(refusal(text).contains("x.yaml:9:11: " + refusal), refusal(text));
        }
    }

    @Test
    void fixedOnesAndOnesAnywhereElseAreNot() {
        assertDoesNotThrow(() -> TestScenes.build(soft("position: [0, 0, 0], fixed: true",
                "position: [0, 0, 0], fixed: true")));
        assertDoesNotThrow(() -> TestScenes.build(soft("position: [0, 0, 0]", "position: [0, 1e-40, 0]")));
    }

    /** The centre of a soft solid has no normal; that of a hollow one, and one's own place outside, do not matter. */
    @ParameterizedTest
    @CsvSource(delimiter = ';', value = {
            "position: [0, 0, 0]; centre: [0, 0, 0]; true",
            "position: [0, 0, 0], velocity: [1, 0, 0]; centre: [0, -0.0, 0]; true",
            "position: [1, 2, 3]; centre: [1, 2, 3]; true",
            "position: [1, 2, 3], fixed: true; centre: [1, 2, 3]; false",
            "position: [1, 2, 3]; centre: [1, 2, 3], hollow: true; false",
            "position: [0, 1e-40, 0]; centre: [0, 0, 0]; false",
            "position: [0, 5, 0]; centre: [0, 0, 0]; false",
    })
    void aParticleAtTheCentreOfASoftSolidIsRefused(String a, String solid, boolean refused) {
        String text = scene("rk4", a, "position: [9, 9, 9]", "effects: [penaltySphere: {" + solid
                + ", radius: 1, stiffness: 10}]\n");
        if (refused) {
            assertTrue(refusal(text).contains("x.yaml:9:11: 'a' is at the centre of penaltySphere, where it has no"
                    + " direction in which to push"), refusal(text));
        } else {
            assertDoesNotThrow(() -> TestScenes.build(text));
        }
    }

    @Test
    void aShapesParticleCountsToo() {
        assertTrue(refusal("""
                title: Two boxes
                teaches: one of them in the other
                solver: rk4
                deltaT: 0.01
                duration: 1
                shapes:
                  - jelly: {id: u, centre: [0, 0, 0], size: [1, 1, 1], columns: 2, rows: 2, layers: 2, totalMass: 1,
                            structural: {stiffness: 9}}
                  - jelly: {id: v, centre: [1, 0, 0], size: [1, 1, 1], columns: 2, rows: 2, layers: 2, totalMass: 1,
                            structural: {stiffness: 9}}
                effects: [repulsion: {radius: 0.1, stiffness: 100}]
                """).contains("are at the same place"));
    }

    @Test
    void aBirthOnABallAtRestEndsTheRunWithBothNames() {
        Scene scene = TestScenes.build(soft("position: [0, 0, 0]", "position: [5, 0, 0]")
                + "rules: [emitter: {id: e, position: [0, 0, 0], speed: 1, rate: 1.3}]\n");
        SimulationException end = assertThrows(SimulationException.class, scene.simulation()::run);
        assertEquals("rk4 stopped at t = 0.769 s: 'a' and 'e[0]' are at the same place; soft balls there have no"
                + " direction in which to push each other", new BlowUpMessage(scene, end, name -> name).lines());
    }

    @ParameterizedTest
    @CsvSource({"0, 1", "1, 1", "10, 0.99", "0, 33", "3, 0.7"})
    void aBirthAtTheCentreOfASoftSolidEndsTheRun(double speed, double rate) {
        Scene scene = TestScenes.build(scene("verlet", "position: [5, 0, 0]", "position: [9, 0, 0]",
                "effects: [penaltySphere: {centre: [1, 0, 0], radius: 1, stiffness: 10}]\n"
                + "rules: [emitter: {id: e, position: [1, 0, 0], speed: " + speed + ", rate: " + rate + "}]\n"));
        SimulationException end = assertThrows(SimulationException.class, scene.simulation()::run);
        assertTrue(end.getMessage().startsWith("'e[0]' is at the centre of penaltySphere"), end.getMessage());
        assertEquals(1 / rate, end.getTime(), 1e-12);
    }

    @Test
    void otherSpringsAndRodsHaveNoDirectionOrLength() {
        assertTrue(refusal(spring("rk4", "")).contains("'a' and 'b' are at the same place; a spring between them would"
                + " have no direction, unless it has restLength: 0"));
        assertTrue(refusal(spring("rk4", ", restLength: 1")).contains("no direction, unless"));
        assertTrue(refusal(spring("rk4", ", restLength: 0, damping: 1")).contains("the damping of a spring between"
                + " them would have no direction"));
        assertTrue(refusal(scene("rk4", "position: [0, 0, 0]", "position: [0, 0, 0]", "rods: [{from: a, to: b}]\n"))
                .contains("a rod between them would have no length"));
    }
}
