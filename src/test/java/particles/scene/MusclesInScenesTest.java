package particles.scene;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.ParticleSystem;
import particles.effects.Muscles;
import particles.law.Effect;
import particles.law.Vector3;
import particles.spec.messages.InvalidInputException;

/** How scenes name muscles: single springs, families of a shape, or all; and waves along them. */
class MusclesInScenesTest {
    private static final String ROPES = """
            title: Two ropes
            teaches: Waves of muscles.
            solver: rk4
            deltaT: 0.01
            duration: 1
            particles:
              - {id: a, position: [0, 2, 0]}
              - {id: b, position: [1, 2, 0]}
            springs:
              - {from: a, to: b, stiffness: 7}
            shapes:
              - rope: {id: one, start: [3, 0, 0], end: [7, 0, 0], particles: 5, mass: 1, structural: {stiffness: 10},
                        bend: {stiffness: 1}}
              - rope: {id: two, start: [0, 0, 1], end: [0, 0, 4], particles: 4, mass: 1, structural: {stiffness: 10}}
            """;

    /** The muscles' forces on all balls, x and z added: a, b, five of the first rope, four of the second. */
    private static double[] forces(String muscles, double time) {
        Scene scene = TestScenes.build(ROPES + "effects: [muscles: {rise: 0, period: 4, " + muscles + "}]");
        Effect found = scene.system().getEffects().stream().filter(Muscles.class::isInstance).findFirst()
                .orElseThrow();
        double[] force = new double[scene.system().getStateSize()];
        found.addForces(scene.system().getOwnState(), time, force);
        double[] sums = new double[11];
        Arrays.setAll(sums, i -> Vector3.at(force, 6 * i + 3).x() + Vector3.at(force, 6 * i + 3).z());
        return sums;
    }

    private static void assertForces(String muscles, double time, double... expected) {
        assertArrayEquals(expected, forces(muscles, time), 1e-14);
    }

    /** Four springs in a wave, each a quarter of a period behind; then the crest is a quarter of a wave further. */
    @Test
    void aWaveRunsAlongAShape() {
        String wave = "amplitude: 0.1, shape: one, wavelength: 4";
        assertForces(wave, 0, 0, 0, 0, 1, -1, -1, 1, 0, 0, 0, 0);
        assertForces(wave, 1, 0, 0, -1, 1, 1, -1, 0, 0, 0, 0, 0);
        assertForces(wave + ", direction: [-2, 0, 0]", 0, 0, 0, -1, 1, 1, -1, 0, 0, 0, 0, 0);
        assertForces(wave + ", phase: 0.25", 0, 0, 0, -1, 1, 1, -1, 0, 0, 0, 0, 0);
    }

    @Test
    void aFamilyAllSpringsOrSingleOnesAreMuscles() {
        assertForces("amplitude: 0.5, shape: one, family: bend", 1, 0, 0, -1, -1, 0, 1, 1, 0, 0, 0, 0);
        assertForces("amplitude: 0.1, shape: two, family: structural", 1, 0, 0, 0, 0, 0, 0, 0, -1, 0, 0, 1);
        assertForces("amplitude: 0.1", 1, -0.7, 0.7, -1.2, -0.2, 0, 0.2, 1.2, -1, 0, 0, 1);
        assertForces("amplitude: 0.1, springs: [{from: b, to: a}, {from: 'two[0]', to: 'two[1]', phase: 0.5}, "
                + "{from: 'two[1]', to: 'two[2]', amplitude: 0.3}]", 1, -0.7, 0.7, 0, 0, 0, 0, 0, 1, -4, 3, 0);
    }

    /** Of the nine springs of a cloth of 3 x 2, two are in its upper row and one at its left side. */
    @Test
    void thePartOfAShapeHasMuscles() {
        String cloth = """
                title: A cloth
                teaches: Muscles along its upper side.
                solver: rk4
                deltaT: 0.01
                duration: 1
                shapes:
                  - cloth: {corner: [0, 0, 0], across: [2, 0, 0], down: [0, -1, 0], columns: 3, rows: 2, mass: 1,
                            structural: {stiffness: 10}, shear: {stiffness: 1}}
                effects:
                  - muscles: {amplitude: 0.1, period: 4, rise: 0, shape: cloth, part: PART}
                """;
        assertEquals(Map.of(0, -1.0, 4, 1.0), pushed(cloth.replace("PART", "top"), 0));
        assertEquals(Map.of(0, 1.0, 1, -1.0), pushed(cloth.replace("PART", "left"), 1));
        String message = assertThrows(InvalidInputException.class, () -> pushed(cloth.replace("PART", "front"), 0))
                .getMessage();
        assertTrue(message.endsWith(": there are no structural springs in part 'front' of 'cloth'"), message);
    }

    /** The forces along one axis at the end of a quarter of a period, by ball; those without any are left out. */
    private static Map<Integer, Double> pushed(String yaml, int axis) {
        ParticleSystem system = TestScenes.build(yaml).system();
        double[] force = new double[system.getStateSize()];
        system.addUpEffects(system.getOwnState(), 1, force);
        Map<Integer, Double> pushed = new HashMap<>();
        for (int i = 0; i < system.getParticles().count(); i++) {
            if (Math.abs(force[6 * i + 3 + axis]) > 1e-9) {
                pushed.put(i, force[6 * i + 3 + axis]);
            }
        }
        return pushed;
    }

    /** Single springs besides a shape have numbers of their own, whether they belong to the shape or not. */
    @Test
    void aSingleSpringOfAShapeHasItsOwnAmplitude() {
        assertForces("amplitude: 0.1, shape: two, springs: [{from: a, to: b}, {from: 'two[1]', to: 'two[0]', "
                + "amplitude: 0}]", 1, -0.7, 0.7, 0, 0, 0, 0, 0, 0, -1, 0, 1);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "springs: [{from: a, to: 'one[0]'}] | x.yaml:15:67: the spring between 'a' and 'one[0]' does not exist",
        "springs: [{from: a, to: b}, {from: b, to: a}] | x.yaml:15:85: the spring between 'b' and 'a' "
            + "appears twice in 'springs'",
        "springs: [{from: a, to: a}] | x.yaml:15:67: the spring between 'a' and 'a' does not exist",
        "springs: [] | x.yaml:15:20: there are no springs",
        "part: top | x.yaml:15:63: 'part' needs 'shape'",
        "family: shear | x.yaml:15:65: 'family' needs 'shape'",
        "direction: [0, 1, 0] | x.yaml:15:68: 'direction' needs 'wavelength'",
        "'shape: two}, muscles: {amplitude: 0, period: 1' | x.yaml:15:79: the spring between 'two[0]' and 'two[1]' "
            + "is a muscle of an earlier 'muscles' already; it can be one of one effect only",
        "shape: two, family: bend | x.yaml:15:64: there are no bend springs in 'two'",
        "shape: a | x.yaml:15:64: there are no structural springs in 'a'",
        "shape: three | x.yaml:15:11: unknown particle 'three'; known: a, b, one, two",
        "springs: [{from: a, to: c}] | x.yaml:15:11: unknown particle 'c'; known: a, b, one, two"})
    void whatIsNoSpringIsRefused(String muscles, String message) {
        String found = assertThrows(InvalidInputException.class, () -> forces("amplitude: 0.1, " + muscles, 0))
                .getMessage();
        assertEquals(message, found);
    }

    @Test
    void aSceneWithoutSpringsHasNoMuscles() {
        String message = assertThrows(InvalidInputException.class, () -> TestScenes.build("""
                title: A ball
                teaches: Nothing.
                solver: rk4
                deltaT: 0.01
                duration: 1
                particles: [{id: a, position: [0, 0, 0]}]
                effects: [muscles: {amplitude: 0.1, period: 1}]
                """)).getMessage();
        assertEquals(": there are no springs", message.substring(message.lastIndexOf(": there")));
    }
}
