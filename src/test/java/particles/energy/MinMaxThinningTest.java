package particles.energy;

import static deSolvers.problems.Bounds.assertAbove;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Thinning against all samples. */
class MinMaxThinningTest {

    @Test
    void fewSamplesAreAllKept() {
        MinMaxThinning extremes = new MinMaxThinning(8);
        for (int k = 0; k < 8; k++) {
            extremes.add(k / 4.0, (k * 3) % 8);
        }
        assertArrayEquals(new double[] {0, 0.25, 0.5, 0.75, 1, 1.25, 1.5, 1.75}, extremes.points()[0]);
        assertArrayEquals(new double[] {0, 3, 6, 1, 4, 7, 2, 5}, extremes.points()[1]);
    }

    /**
     * 100,000 random samples on 64 buckets: every point kept is a sample, in order, and every part keeps its extremes.
     */
    @Test
    void noExtremeIsLost() {
        Random random = new Random(715);
        int n = 100_000;
        double[] values = new double[n];
        MinMaxThinning extremes = new MinMaxThinning(64);
        for (int k = 0; k < n; k++) {
            values[k] = random.nextGaussian() + (k == 77_777 ? 50 : 0);
            extremes.add(k, values[k]);
        }
        double[][] points = extremes.points();
        assertTrue(points[0].length <= 2 * 64 + 2, points[0].length + " points");
        assertAbove(64, points[0].length);
        for (int p = 0; p < points[0].length; p++) {
            assertEquals(values[(int) points[0][p]], points[1][p]);
            assertTrue(p == 0 || points[0][p] > points[0][p - 1]);
        }
        assertEquals(0, points[0][0]);
        assertEquals(n - 1, points[0][points[0].length - 1]);
        assertEquals(Arrays.stream(values).max().orElseThrow(), extremes.largest());
        assertEquals(Arrays.stream(values).min().orElseThrow(), extremes.smallest());
        int part = 2048;                                        // 64 buckets of 2048 hold 131,072 samples
        for (int from = 0; from < n; from += part) {
            int to = Math.min(n, from + part);
            double most = Arrays.stream(values, from, to).max().orElseThrow();
            double kept = Double.NEGATIVE_INFINITY;
            for (int p = 0; p < points[0].length; p++) {
                kept = points[0][p] >= from && points[0][p] < to ? Math.max(kept, points[1][p]) : kept;
            }
            assertEquals(most, kept, "from sample " + from);
        }
    }
}
