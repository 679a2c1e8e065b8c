package deSolvers.adaptive;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

/** Errors relative to the tolerance, against values computed by hand. */
class ToleranceTest {
    private static final double MAX = Double.MAX_VALUE;

    @Test
    void theLargestRatioCountsAndItsEntryIsKnown() {
        Tolerance tolerance = new Tolerance(0.5, 0.25);
        assertEquals(0.5, tolerance.getRelative());
        assertEquals(-1, tolerance.getWorstEntry());
        // allowed: 0.25 + 0.5 * 2, 0.25 + 0.5 * 10, 0.25 + 0
        assertEquals(8, tolerance.ratio(new double[] {0.5, -3, 2}, new double[] {1, 10, 0}, new double[] {-2, 4, 0}));
        assertEquals(2, tolerance.getWorstEntry());
        assertEquals(12, tolerance.ratio(new double[] {0.5, -63, 2}, new double[] {1, 10, 0}, new double[] {-2, 4, 0}));
        assertEquals(1, tolerance.getWorstEntry());
        assertEquals(0.4, tolerance.ratio(new double[] {0.5, 0.5}, new double[] {2, 2}, new double[] {0, 2}));
        assertEquals(0, tolerance.getWorstEntry(), "the first of two");
        assertEquals(0, tolerance.ratio(new double[2], new double[2], new double[2]));
        assertEquals(0, tolerance.getWorstEntry());
        assertEquals(0, tolerance.ratio(new double[0], new double[0], new double[0]));
        assertEquals(-1, tolerance.getWorstEntry());
        // allowed: 0.25, 0.25 + 0.5 * 2
        assertEquals(12, tolerance.size(new double[] {3, -4}, new double[] {0, 2}));
        assertEquals(3.2, tolerance.size(new double[] {0.25, -4}, new double[] {0, -2}));
    }

    @Test
    void nonFiniteValuesHaveAnInfiniteError() {
        Tolerance tolerance = new Tolerance(0, 1);
        for (double bad : new double[] {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY}) {
            assertEquals(Double.POSITIVE_INFINITY, tolerance.ratio(new double[] {5, bad, 0}, new double[3],
                    new double[3]));
            assertEquals(1, tolerance.getWorstEntry());
            assertEquals(Double.POSITIVE_INFINITY, tolerance.ratio(new double[3], new double[3],
                    new double[] {0, 0, bad}));
            assertEquals(2, tolerance.getWorstEntry());
        }
        assertEquals(MAX, tolerance.ratio(new double[] {MAX}, new double[1], new double[1]),
                "the largest number is one");
        assertEquals(0, tolerance.ratio(new double[1], new double[] {MAX}, new double[] {-MAX}));
        assertEquals(0, new Tolerance(1, 0).ratio(new double[1], new double[1], new double[1]), "0 of nothing allowed");
        assertEquals(Double.POSITIVE_INFINITY, new Tolerance(1, 0).ratio(new double[] {1e-300}, new double[1],
                new double[1]));
    }
}
