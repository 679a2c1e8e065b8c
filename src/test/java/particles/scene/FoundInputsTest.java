package particles.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static particles.Texts.assertHas;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import particles.spec.messages.InvalidInputException;

/** Texts that {@code gradle fuzz} found, each in its smallest form. */
class FoundInputsTest {
    private static List<String> linesFor(String scene) {
        String head = "title: a\nteaches: b\nsolver: rk4\ndeltaT: 0.01\nduration: 1\n";
        return assertThrows(InvalidInputException.class, () -> TestScenes.build(head + scene)).getLines();
    }

    /**
     * A mass whose inverse is infinite, and one whose half is 0: both ended in an IllegalArgumentException. Java reads
     * 1e-400 as 0.
     */
    @ParameterizedTest
    @CsvSource(textBlock = """
            4.9e-324
            1e-310
            1e-41
            1e-400
            """)
    void massesThatHaveNoInverseOrAreRoundedTo0AreRefused(String mass) {
        assertEquals(List.of("x.yaml:7:42: 'mass' is " + mass + "; positive numbers in a scene are at least 1e-40"),
                linesFor("particles:\n  - {id: bob, position: [0, 0, 0], mass: " + mass + "}\n"));
        assertEquals(List.of("x.yaml:7:71: 'totalMass' is " + mass
                + "; positive numbers in a scene are at least 1e-40"),
                linesFor("shapes:\n  - rope: {start: [0, 0, 0], end: [1, 0, 0], particles: 3,"
                        + " totalMass: " + mass + "}\n"));
    }

    /** Sparks that live for a second, born for 10,000 s within one step: dead ones filled the memory. */
    @Test
    void birthsOfOneEndlessStepAreCounted() {
        String scene = "title: a\nteaches: b\nsolver: rk4\ndeltaT: 10000\nduration: 30000\nparticles:\n  - {id:"
                + " a, position: [0, 0, 0]}\n"
                + "rules:\n  - emitter: {id: spark, position: [0, 0, 0], speed: 1, rate: 1e6, lifetime: 2}\n";
        String line = assertThrows(InvalidInputException.class, () -> TestScenes.build(scene)).getLines().get(0);
        assertHas(line, "MiB of memory for 10002000001 particles");
    }

    /** A text that ends within an escape, and one with too large a number: both ended in a NumberFormatException. */
    @ParameterizedTest
    @ValueSource(strings = {"\\u", "\\U", "\\x", "\\UFFFFFFFF", "\\U80000000\"\n# \\Ufffffffe\n"})
    void invalidEscapesAreRefused(String escape) {
        assertEquals(List.of("""
                x.yaml:6:13: not valid YAML: an escape has to give a character's number in hexadecimal digits, such \
                as \\xe9, \\u00e9 or \\U000000e9"""), linesFor("camera: \"abc" + escape));
    }
}
