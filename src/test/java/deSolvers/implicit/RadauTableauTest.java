package deSolvers.implicit;

import static deSolvers.implicit.RadauTableau.S6;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hipparchus.linear.Array2DRowRealMatrix;
import org.junit.jupiter.api.Test;

/** The numbers of the method against each other: order conditions, and the split of its matrix. */
class RadauTableauTest {
    private static final double[][] A = {
        {(88 - 7 * S6) / 360, (296 - 169 * S6) / 1800, (-2 + 3 * S6) / 225},
        {(296 + 169 * S6) / 1800, (88 + 7 * S6) / 360, (-2 - 3 * S6) / 225},
        {(16 - S6) / 36, (16 + S6) / 36, 1.0 / 9}};

    /**
     * With B(5) and C(3) and the last row for weights, the method has order 5 (Butcher 1964); a sixth condition fails.
     */
    @Test
    void orderConditions() {
        for (int k = 1; k <= 6; k++) {
            double sum = 0;
            for (int i = 0; i < 3; i++) {
                sum += A[2][i] * StrictMath.pow(RadauTableau.c(i), k - 1);
                double stage = 0;
                for (int j = 0; j < 3; j++) {
                    stage += A[i][j] * StrictMath.pow(RadauTableau.c(j), k - 1);
                }
                if (k <= 3) {
                    assertEquals(StrictMath.pow(RadauTableau.c(i), k) / k, stage, 1e-16 * 4,
                            "C(" + k + "), stage " + i);
                }
            }
            if (k <= 5) {
                assertEquals(1.0 / k, sum, 4e-16, "B(" + k + ")");
            } else {
                assertTrue(Math.abs(sum - 1.0 / 6) > 1e-4, "order 6 would be one more than there is");
            }
        }
    }

    @Test
    void theChangeOfVariablesSplitsTheInverse() {
        double[][] identity = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        double[][] split = {{RadauTableau.MU, 0, 0}, {0, RadauTableau.MU_RE, -RadauTableau.MU_IM},
            {0, RadauTableau.MU_IM, RadauTableau.MU_RE}};
        double[][] inverse = new double[3][3];
        double[][] back = new double[3][3];
        RadauTableau.transform(true, identity, inverse);
        RadauTableau.transform(false, inverse, back);
        assertIdentity(back);
        RadauTableau.transform(false, product(split, inverse), back);
        assertIdentity(product(A, back));
    }

    /** Measured at most 1.9e-15, with entries of the factors up to 6. */
    private static void assertIdentity(double[][] matrix) {
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                assertEquals(i == j ? 1 : 0, matrix[i][j], 1e-14);
            }
        }
    }

    private static double[][] product(double[][] a, double[][] b) {
        return new Array2DRowRealMatrix(a).multiply(new Array2DRowRealMatrix(b)).getData();
    }

    /** The polynomial goes through the stages, and with z = c it is u itself. */
    @Test
    void theCollocationPolynomialGoesThroughTheStages() {
        for (int at = 0; at < 3; at++) {
            double u = RadauTableau.c(at);
            for (int stage = 0; stage < 3; stage++) {
                double[][] z = new double[3][1];
                z[stage][0] = 1;
                double value = u * (RadauTableau.polynomial(1, z, 0)
                        + u * (RadauTableau.polynomial(2, z, 0) + u * RadauTableau.polynomial(3, z, 0)));
                assertEquals(at == stage ? 1 : 0, value, 2e-14);
            }
        }
    }

    /** The estimate compares with a formula of order 3 that has the derivative at the start for a fourth stage. */
    @Test
    void theErrorEstimateVanishesForPolynomialsOfDegreeThree() {
        // s = u^k: z_i = c_i^k, h f = k at the start for k = 1, else 0
        for (int k = 1; k <= 4; k++) {
            double[][] z = new double[3][1];
            for (int i = 0; i < 3; i++) {
                z[i][0] = StrictMath.pow(RadauTableau.c(i), k);
            }
            double estimate = (k == 1 ? 1 : 0) - RadauTableau.polynomial(1, z, 0);
            if (k <= 3) {
                assertEquals(0, estimate, 4e-15, "degree " + k);
            } else {
                assertTrue(Math.abs(estimate) > 0.01, "degree 4 is seen: " + estimate);
            }
        }
    }
}
