package particles.scene;

import static deSolvers.problems.Bounds.assertBelow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static particles.Texts.assertHas;
import static particles.Texts.assertStarts;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import particles.scene.format.SceneFormat;
import particles.spec.Reading;
import particles.spec.messages.InvalidInputException;
import particles.spec.messages.Problems;

/** Common typing mistakes are named, with what to write instead. */
class TypingMistakesTest {
    private static final String SCENE = """
            title: Typing
            teaches: what mistakes are called
            solver: rk4
            deltaT: 0.01
            duration: 1
            particles:
              - {id: bob, position: [0, 1, 0]}
            effects:
              - gravity
            """;

    private static List<String> problems(String text) {
        return assertThrows(InvalidInputException.class,
                () -> TestScenes.read(text), text).getLines();
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
            0,01                | a number has a decimal point, not a comma; write 0.01
            10 ms               | write the number without its unit: 0.01
            0.01 s              | write the number without its unit: 0.01
            0.01s               | write the number without its unit: 0.01
            1 fortnight         | write the number without a unit; here it is in s
            1/50                | expressions are not calculated; write 0.02
            10^-2               | expressions are not calculated; write 0.01
            2*10**-3            | expressions are not calculated; write 0.002
            "0.01"              | a number has no quotes; write 0.01
            '0.01'              | a number has no quotes; write 0.01
            \u22120.01          | a character of it only looks like an ordinary digit, sign or space; write -0.01
            \u20130.01          | a character of it only looks like an ordinary digit, sign or space; write -0.01
            \u00a00.01          | a character of it only looks like an ordinary digit, sign or space; write 0.01
            \uff10\uff0e0\uff11 | a character of it only looks like an ordinary digit, sign or space; write 0.01
            \u0661e-2           | a character of it only looks like an ordinary digit, sign or space; write 1e-2
            \uff10\uff0c01      | a number has a decimal point, not a comma; write 0.01
            0x1p-3              | a hexadecimal number has no sign, point or exponent; write it in decimal digits
            -0x1F               | a hexadecimal number has no sign, point or exponent; write it in decimal digits
            1e-400              | positive numbers in a scene are at least 1e-40
            \u201c0.01\u201d    | curly quotes are part of the text: type ordinary ones, or none
            """)
    void theErrorForAMistypedNumberSaysWhatToWrite(String typed, String advice) {
        List<String> lines = problems(SCENE.replace("deltaT: 0.01", "deltaT: " + typed));
        assertEquals(1, lines.size(), lines::toString);
        assertStarts(lines.get(0), "x.yaml:4:9: 'deltaT' is ");
        assertTrue(lines.get(0).endsWith("; " + advice), lines.get(0));
    }

    /** In YAML, a line that begins with % is a directive; YAML 3.0 is none that there is. */
    @ParameterizedTest
    @ValueSource(strings = {"%YAML 3.0", "% a comment", "%"})
    void aLineThatBeginsWithPercentIsReportedInItsPlace(String line) {
        String message = ": a line cannot begin with %; a comment begins with #";
        assertEquals(List.of("x.yaml:2:1" + message), problems("# a scene\n" + line + "\n---\n" + SCENE));
        assertEquals(List.of("x.yaml:1:1" + message), problems(line + "\r\n" + SCENE.replace("\n", "\r\n")));
        assertEquals(List.of("x.yaml:10:1" + message), problems(SCENE + line + "\n"));
        assertEquals("Typing", TestScenes.read("%YAML 1.2\n---\n" + SCENE).title());
    }

    @Test
    void curlyQuotesAroundAnyValueAreNamed() {
        String advice = "; curly quotes are part of the text: type ordinary ones, or none";
        for (String line : List.of("solver: \u2018rk4\u2019", "threads: \u201e2\u201c", "impact: \u00abexact\u00bb",
                "look: {fixedColour: \u201c#ff0000\u201d}", "output: {energy: \u201ctrue\u201d}",
                "\u201cimpact\u201d: exact")) {
            List<String> lines = problems(SCENE.replace("solver: rk4", line + (line.contains("rk4") ? ""
                    : "\nsolver: rk4")));
            assertTrue(lines.get(0).startsWith("x.yaml:3:") && lines.get(0).endsWith(advice), lines.get(0));
        }
        assertEquals("\u201cTyping\u201d", TestScenes.read(SCENE.replace("Typing", "\u201cTyping\u201d")).title());
    }

    @ParameterizedTest
    @CsvSource(textBlock = """
            dt,deltaT
            h,deltaT
            timestep,deltaT
            DT,deltaT
            method,solver
            integrator,solver
            """)
    void theCommonNameOfAKeyIsUnderstood(String typed, String key) {
        List<String> lines = problems(SCENE.replace(key + ":", typed + ":"));
        assertEquals(1, lines.size(), lines::toString);
        assertHas(lines.get(0), ": unknown key '" + typed + "'; did you mean '" + key + "'?");
    }

    /** The texts of 20,000 mistakes took five seconds. */
    @Test
    void aFileFullOfMistakesIsReadUpToTheFirst50() {
        for (String mistake : List.of("  - {id: a, positon: [0, 0, 0], mass: x}\n", "key%d: 3\n")) {
            StringBuilder text = new StringBuilder(mistake.startsWith("key") ? "" : "particles:\n");
            IntStream.range(0, 500).forEach(i -> text.append(mistake.formatted(i)));
            Reading in = new Reading("x.yaml", new Problems());
            SceneFormat.SCENE.read(text.toString().getBytes(StandardCharsets.UTF_8), in);
            assertBelow(60, in.problems().count());
            assertEquals(51, problems(text.toString()).size());
        }
    }
}
