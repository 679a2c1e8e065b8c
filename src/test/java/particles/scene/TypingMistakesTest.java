package particles.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

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
        return assertThrows(SceneException.class,
                () -> TestScenes.read(text), text).getLines();
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
        "0,01|a number has a decimal point, not a comma; write 0.01",
        "10 ms|write the number without its unit: 0.01",
        "0.01 s|write the number without its unit: 0.01",
        "0.01s|write the number without its unit: 0.01",
        "1 fortnight|write the number without a unit; here it is in s",
        "1/50|expressions are not calculated; write 0.02",
        "10^-2|expressions are not calculated; write 0.01",
        "2*10**-3|expressions are not calculated; write 0.002",
        "\"0.01\"|a number has no quotes; write 0.01",
        "'0.01'|a number has no quotes; write 0.01",
        "\u22120.01|its minus sign is not an ordinary hyphen; write -0.01",
        "\u20130.01|its minus sign is not an ordinary hyphen; write -0.01",
        "\u00a00.01|it contains a no-break space; type an ordinary space instead"})
    void theErrorForAMistypedNumberSaysWhatToWrite(String typed, String advice) {
        List<String> lines = problems(SCENE.replace("deltaT: 0.01", "deltaT: " + typed));
        assertEquals(1, lines.size(), lines::toString);
        assertTrue(lines.get(0).startsWith("x.yaml:4:9: 'deltaT' is "), lines.get(0));
        assertTrue(lines.get(0).endsWith("; " + advice), lines.get(0));
    }

    @ParameterizedTest
    @CsvSource({"soon", "1.2.3", "1/0", "1/2/3"})
    void theErrorForAnyOtherValueSaysWhatIsAllowed(String typed) {
        assertEquals(List.of("x.yaml:4:9: 'deltaT' is the text '" + typed + "'; it has to be a number over 0 (s)"),
                problems(SCENE.replace("deltaT: 0.01", "deltaT: " + typed)));
    }

    @Test
    void mistakesInOptionsAreNamedAsInFiles() {
        assertEquals(List.of("-PdeltaT: the value is the text '0,01'; a number has a decimal point, not a comma;"
                + " write 0.01"), assertThrows(SceneException.class,
                        new Overrides().with("deltaT", "0,01", "-PdeltaT")::check).getLines());
    }

    /** The parser reports both a line later. */
    @Test
    void aMissingSpaceAndANoBreakSpaceAreReportedInTheirLine() {
        assertEquals(List.of("x.yaml:4:8: a space is missing after 'deltaT:'; write 'deltaT: 0.01'"),
                problems(SCENE.replace("deltaT: 0.01", "deltaT:0.01")));
        assertEquals(List.of("x.yaml:4:8: a no-break space is here, which YAML does not take for a space; type an"
                + " ordinary space instead"), problems(SCENE.replace("deltaT: 0.01", "deltaT:\u00a00.01")));
    }

    @Test
    void theErrorForAnEffectUnderRulesSaysWhereItBelongs() {
        assertEquals(List.of("x.yaml:11:5: 'drag' is an effect, not a rule; move it to 'effects'"),
                problems(SCENE + "rules:\n  - drag: {coefficient: 1}\n"));
        assertEquals(List.of("x.yaml:10:5: 'ground' is a rule, not an effect; move it to 'rules'"),
                problems(SCENE + "  - ground\n"));
    }

    @Test
    void anUnsupportedYamlVersionIsReportedWithItsPlace() {
        List<String> lines = problems("# a scene\n%YAML 3.0\n---\n" + SCENE);
        assertEquals(1, lines.size());
        assertTrue(lines.get(0).startsWith("x.yaml:2:1: not valid YAML: "), lines.get(0));
    }

    @Test
    void invisibleCharactersInIdsAreRefusedAndShownAsCodes() {
        List<String> lines = problems(SCENE.replace("bob", "b\u202eo\u200bb"));
        assertEquals(List.of("x.yaml:7:10: 'id' is the text 'bU+202EoU+200Bb'; it has to be a name of at most 60"
                + " characters without spaces, brackets, commas, quotes and invisible characters"), lines);
        assertEquals(lines.get(0).replace("bU+202EoU+200Bb", "x".repeat(37) + "..."),
                problems(SCENE.replace("bob", "x".repeat(100))).get(0));
    }
}
