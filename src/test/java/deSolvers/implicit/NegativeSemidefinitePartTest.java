package deSolvers.implicit;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.Random;
import org.ejml.dense.row.RandomMatrices_DDRM;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Of a symmetric matrix with known eigenvalues along known axes what has the negative ones is left. */
class NegativeSemidefinitePartTest {
    private final NegativeSemidefinitePart part = new NegativeSemidefinitePart();
    private final Random random = new Random(6);

    /** Three unit vectors at right angles, by rows. */
    private double[] axes() {
        return RandomMatrices_DDRM.orthogonal(3, 3, random).data;
    }

    /** The sum of e n n^T over the axes. */
    private static double[] matrix(double[] axes, double... eigenvalues) {
        double[] k = new double[9];
        for (int e = 0; e < 27; e++) {
            k[e % 9] += eigenvalues[e / 9] * axes[3 * (e / 9) + e % 9 / 3] * axes[3 * (e / 9) + e % 3];
        }
        return k;
    }

    private static double[] negative(double... eigenvalues) {
        return Arrays.stream(eigenvalues).map(e -> Math.min(0, e)).toArray();
    }

    private void assertPart(double[] axes, double... eigenvalues) {
        double[] result = new double[9];
        double largest = Arrays.stream(eigenvalues).map(Math::abs).max().orElseThrow();
        part.compute(matrix(axes, eigenvalues), result);
        assertArrayEquals(matrix(axes, negative(eigenvalues)), result, 2e-14 * largest);       // measured 4.9e-15
    }

    /**
     * As forces and their squares are large or small: also along the axes themselves, where there is nothing to turn.
     */
    @ParameterizedTest
    @ValueSource(doubles = {1, 1e-200, 1e12, 1e200})
    void whatPullsBackIsLeft(double size) {
        double[] straight = {1, 0, 0, 0, 1, 0, 0, 0, 1};
        for (int n = 0; n < 200; n++) {
            double[] axes = n == 0 ? straight : axes();
            double[] e = random.doubles(3, -size, size).toArray();
            assertPart(axes, e);
            assertPart(axes, -size, -size, size);       // as across a spring that is compressed
            assertPart(axes, -size, 1e-3 * size, 1e-6 * size);
            assertPart(axes, size, 2 * size, 3 * size);
            assertPart(axes, -size, -2 * size, -3 * size);
            assertPart(axes, size, 0, 0);
        }
        // Turned by almost nothing, by a quarter about one axis, and in one plane only.
        double[] k = {-2 * size, 1e-170 * size, 0, 1e-170 * size, 3 * size, 0, 0, 0, -size};
        double[] result = new double[9];
        part.compute(k, result);
        assertArrayEquals(new double[] {-2 * size, 0, 0, 0, 0, 0, 0, 0, -size}, result, 1e-15 * size);
        for (int[] plane : new int[][] {{0, 1, 2}, {0, 2, 1}, {1, 2, 0}}) {
            double[] turned = new double[9];
            turned[3 * plane[0] + plane[1]] = size;
            turned[3 * plane[1] + plane[0]] = size;     // eigenvalues +size and -size along the diagonals
            part.compute(turned, result);
            double[] expected = new double[9];
            for (int[] entry : new int[][] {{0, 0, -1}, {1, 1, -1}, {0, 1, 1}, {1, 0, 1}}) {
                expected[3 * plane[entry[0]] + plane[entry[1]]] = entry[2] * size / 2;
            }
            assertArrayEquals(expected, result, 1e-15 * size);
        }
    }

    /** What is skew does not push or pull: only the symmetric part counts. */
    @Test
    void theSkewPartIsLeftOut() {
        double[] axes = axes();
        double[] k = matrix(axes, -3, 2, -1);
        double[] skew = k.clone();
        skew[1] += 5;
        skew[3] -= 5;
        skew[2] -= 7;
        skew[6] += 7;
        double[] result = new double[9];
        part.compute(skew, result);
        assertArrayEquals(matrix(axes, -3, 0, -1), result, 1e-14);
        part.compute(new double[9], result);
        assertEquals(0, Arrays.stream(result).map(Math::abs).sum());
    }
}
