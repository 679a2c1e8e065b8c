package deSolvers.adaptive;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A polynomial of degree m + 4 is found again from its ends and its first m + 1 coefficients at the middle. */
class CentredHermiteTest {

    private static double[] atU(double[] a, double u) {
        double value = 0;
        double rate = 0;
        for (int k = a.length - 1; k >= 0; k--) {
            rate = rate * u + value;
            value = value * u + a[k];
        }
        return new double[] {value, rate};
    }

    @ParameterizedTest
    @ValueSource(ints = {-1, 0, 1, 2, 3, 4, 5})
    void polynomialsAreFoundAgain(int m) {
        double[][] polynomials = {{3, -2, 5, 0.5, 7, -1, 2, 0.25, -4, 1.5}, {0, 1, -1, 2, 3, 0, -0.5, 1, 8, -2}};
        double h = 0.25;
        double[][] c = new double[m + 5][2];
        double[][] ends = new double[4][2];
        for (int i = 0; i < 2; i++) {
            double[] a = Arrays.copyOf(polynomials[i], m + 5);
            for (int k = 0; k <= m; k++) {
                c[k][i] = a[k];
            }
            ends[0][i] = atU(a, -0.5)[0];
            ends[1][i] = atU(a, -0.5)[1] / h;
            ends[2][i] = atU(a, 0.5)[0];
            ends[3][i] = atU(a, 0.5)[1] / h;
        }
        CentredHermite.complete(c, m, ends[0], ends[1], ends[2], ends[3], h);
        for (int k = 0; k < m + 5; k++) {
            for (int i = 0; i < 2; i++) {
                assertEquals(polynomials[i][k], c[k][i], 1e-15, "power " + k);       // measured 0: they are all short
            }
        }
    }
}
