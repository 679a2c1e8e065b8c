package deSolvers.rungeKutta;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests reading of tableaux, and refusal of malformed ones. */
class ButcherTableauTest {
    /** Heun's third-order method, with Euler's step as a second line. */
    private static final String HEUN = """
             0  |
            1/3 | 1/3
            2/3 |  0   2/3
            ----+--------------
                | 1/4   0   3/4
                |  1    0    0
            """;

    @Test
    void coefficientsAreReadFromTheirPlaces() {
        ButcherTableau heun = ButcherTableau.parse(HEUN);
        assertEquals(3, heun.getStages());
        assertArrayEquals(new double[] {0, 1.0 / 3, 2.0 / 3}, new double[] {heun.node(0), heun.node(1), heun.node(2)});
        assertEquals(1.0 / 3, heun.row(1)[0]);
        assertEquals(0, heun.row(2)[0]);
        assertEquals(2.0 / 3, heun.row(2)[1]);
        assertArrayEquals(new double[] {0.25, 0, 0.75}, heun.weights(0));
        assertArrayEquals(new double[] {1, 0, 0}, heun.weights(1));
        heun.weights(0)[0] = 17;
        assertEquals(0.25, heun.weights(0)[0], "a copy");
    }

    @Test
    void aBarMayStandAtTheVeryBeginning() {
        ButcherTableau euler = ButcherTableau.parse("0 |\n--\n| 1");
        assertArrayEquals(new double[] {1}, euler.weights(0));
    }

    @ParameterizedTest
    @CsvSource(delimiter = ';', value = {
        "'0 |\n1/2 1/2\n--\n| 0 1';                 a line of a tableau has 2 numbers instead of 1: [0.5, 0.5]",
        "'0 |\n1/2 | 1/2 1/2\n--\n| 0 1';           a line of a tableau has 2 numbers instead of 1: [0.5, 0.5]",
        "'0 |\n1/2 | 1/2\n--\n| 1';                 a line of a tableau has 1 numbers instead of 2: [1.0]",
        "'0 |\n1/2/3 | 1/2\n--\n| 0 1';             'For input string: \"2/3\"'",
        "'0 |\n1/2 | 1/2';                          a line of a tableau has 0 numbers instead of 2: []"})
    void malformedTableauxAreRefused(String printed, String message) {
        Exception e = assertThrows(IllegalArgumentException.class, () -> ButcherTableau.parse(printed));
        assertTrue(e.getMessage().startsWith(message), e.getMessage());
    }
}
