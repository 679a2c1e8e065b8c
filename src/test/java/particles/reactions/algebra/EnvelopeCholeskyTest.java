package particles.reactions.algebra;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;

/** The envelope factorisation solves random systems and detects singular ones. */
class EnvelopeCholeskyTest {

    /** Random matrices B B<sup>T</sup> with envelopes of any shape: A x comes back as b. Measured: 3e-13. */
    @Test
    void randomSystemsAreSolved() {
        Random random = new Random(3);
        for (int n = 1; n <= 12; n++) {
            int[] first = new int[n];
            double[][] lower = new double[n][n];
            for (int r = 0; r < n; r++) {
                first[r] = random.nextInt(r + 1);
                for (int c = first[r]; c <= r; c++) {
                    lower[r][c] = c == r ? 1 + random.nextDouble() : random.nextGaussian();
                }
            }
            EnvelopeCholesky cholesky = new EnvelopeCholesky(first);
            double[][] a = new double[n][n];
            double[] b = new double[n];
            double[] exact = random.doubles(n, -1, 1).toArray();
            for (int r = 0; r < n; r++) {
                for (int c = 0; c < n; c++) {
                    for (int k = 0; k < n; k++) {
                        a[r][c] += lower[r][k] * lower[c][k];
                    }
                    b[r] += a[r][c] * exact[c];
                }
                for (int c = first[r]; c <= r; c++) {
                    cholesky.add(r, c, a[r][c]);
                }
            }
            assertTrue(cholesky.factorise(1e-12));
            cholesky.solve(b);
            for (int r = 0; r < n; r++) {
                assertEquals(exact[r], b[r], 1e-10);
                assertEquals(lower[r][r], cholesky.get(r, r), 1e-11);
            }
        }
    }

    @Test
    void dependentRowsAreDetected() {
        EnvelopeCholesky cholesky = new EnvelopeCholesky(new int[] {0, 0});
        cholesky.add(0, 0, 4);
        cholesky.add(1, 0, 2);
        cholesky.add(1, 1, 1);
        assertFalse(cholesky.factorise(1e-12));
    }
}
