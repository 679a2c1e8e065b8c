package particles.teaching.exercises;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static particles.Texts.assertHas;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import particles.spec.messages.InvalidInputException;

/** What students type as a number. */
class AnswerTextTest {

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            0.125             | 0.125
            0,125             | 0.125
            -1.5              | -1.5
            \u22121.5         | -1.5
            +2                | 2
            .5                | 0.5
            3.                | 3
            1/8               | 0.125
            1 / 8             | 0.125
            1,5/3             | 0.5
            1.25e-1           | 0.125
            1.25E-1           | 0.125
            1.25 x 10^-1      | 0.125
            1,25*10^-1        | 0.125
            0.125 m/s         | 0.125
            0.125m / s        | 0.125
            -1/8 m/s          | -0.125
            1.25 e-1          | 0.125
            v = 0.125         | 0.125
            = 0,125 m/s       | 0.125
            \u22480.125       | 0.125
            0.125 ms^-1       | 0.125
            0.125 m\u00b7s^-1 | 0.125
            """)
    void numbersAreRead(String typed, double value) {
        assertEquals(value, AnswerText.read(typed, "m/s"));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            ''         | The answer is empty
            '  '       | The answer is empty
            NaN        | 'NaN' is no finite number
            -Infinity  | '-Infinity' is no finite number
            1e999      | is no finite number
            1/0        | is no finite number
            0/0        | is no finite number
            1,234.5    | has two points or commas
            1.234,5    | has two points or commas
            one        | 'one' is not a number
            --1        | is not a number
            0.125 cm/s | 'cm/s' after the number is not understood: the answer is wanted in m/s
            0.1 0.2    | not understood
            12 %       | not understood
            """)
    void everythingElseGetsOneClearLine(String typed, String problem) {
        String found = problem(typed, "m/s");
        assertHas(found, problem);
        assertEquals(1, found.lines().count());
    }

    private static String problem(String typed, String unit) {
        return assertThrows(InvalidInputException.class, () -> AnswerText.read(typed, unit)).getMessage();
    }

    @Test
    void aUnitMayBeWrittenOtherwise() {
        for (String unit : List.of("N s/m", "Ns/m", "N*s/m", "N\u00b7s/m", "kg/s")) {
            assertEquals(0.5, AnswerText.read("0.5 " + unit, "N s/m"), unit);
        }
        assertHas(problem("0.5 kg", "N s/m"), "not understood");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {"112.5 %|1.125", "112,5%|1.125", "1.125|1.125"})
    void pureNumbersMayBePercentages(String typed, double value) {
        assertEquals(value, AnswerText.read(typed, ""));
    }
}
