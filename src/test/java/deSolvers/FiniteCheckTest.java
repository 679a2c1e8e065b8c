package deSolvers;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Each entry is checked by itself: a sum of large finite entries does not count as infinite. */
class FiniteCheckTest {
    private static double[] large(int n) {
        double[] values = new double[n];
        Arrays.fill(values, Double.MAX_VALUE);
        return values;
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 3, 4, 5, 7, 8, 9, 16, 21})
    void theFirstNonFiniteEntryIsFound(int n) {
        assertEquals(-1, FiniteCheck.firstNonFinite(large(n)));
        for (int i = 0; i < n; i++) {
            for (double bad : ContractBasics.NOT_FINITE) {
                double[] values = large(n);
                values[i] = bad;
                assertEquals(i, FiniteCheck.firstNonFinite(values));
                values[n - 1] = bad;
                assertEquals(i, FiniteCheck.firstNonFinite(values), "the last one is another");
            }
        }
    }
}
