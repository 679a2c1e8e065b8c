package deSolvers.linear;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.BitSet;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The plan of an elimination beside the elimination itself, carried out entry by entry on a full pattern. */
class FrontalPlanTest {

    /** For each place, the rows below that are filled in when particles are eliminated in the plan's order. */
    private static BitSet[] fill(BlockPattern pattern, FrontalPlan plan) {
        int n = pattern.rows;
        BitSet[] below = new BitSet[n];
        for (int k = 0; k < n; k++) {
            below[k] = new BitSet(n);
            int i = plan.order[k];
            for (int s = pattern.rowStart[i]; s < pattern.rowStart[i + 1]; s++) {
                below[k].set(plan.place[pattern.column[s]]);
            }
        }
        for (int k = 0; k < n; k++) {
            below[k].clear(0, k + 1);
            for (int row = below[k].nextSetBit(0); row >= 0; row = below[k].nextSetBit(row + 1)) {
                below[row].or(below[k]);                // whom it touched touch each other from now on
            }
        }
        return below;
    }

    private static int first(BitSet below) {
        return below.nextSetBit(0);
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("deSolvers.linear.FrontalFactorsTest#nets")
    void theOrderTakesEachSubtreeTogether(String name, BlockPattern pattern) {
        FrontalPlan plan = new FrontalPlan(pattern, Long.MAX_VALUE);
        int n = pattern.rows;
        for (int k = 0; k < n; k++) {
            assertEquals(k, plan.place[plan.order[k]]);
        }
        assertArrayEquals(IntStream.range(0, n).toArray(), IntStream.of(plan.order).sorted().toArray());
        BitSet[] below = fill(pattern, plan);
        for (int k = 0; k < n; k++) {
            for (int m = k + 1; m < first(below[k]); m++) {
                assertTrue(first(below[m]) > 0 && first(below[m]) <= first(below[k]),
                        "between " + k + " and its heir comes "
                        + m);
            }
        }
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("deSolvers.linear.FrontalFactorsTest#nets")
    void groupsHoldWhatIsFilledInAndFewZeros(String name, BlockPattern pattern) {
        FrontalPlan plan = new FrontalPlan(pattern, Long.MAX_VALUE);
        BitSet[] below = fill(pattern, plan);
        long stored = 0;
        long operations = 0;
        long symmetricOperations = 0;
        int largest = 0;
        assertEquals(0, plan.groupStart[0]);
        assertEquals(pattern.rows, plan.groupStart[plan.groups]);
        for (int g = 0; g < plan.groups; g++) {
            int end = plan.groupStart[g + 1];
            BitSet rows = new BitSet();
            long filled = 0;
            for (int k = plan.groupStart[g]; k < end; k++) {
                rows.or(below[k]);
                filled += below[k].cardinality();
                int front = end - 1 - k + plan.height(g);              // rows below this one in its front
                stored += front;
                // each with the pivot's inverse, then with each other
                operations += front * (front + 1L);
                symmetricOperations += front + front * (front + 1L) / 2;
                assertTrue(k + 1 == end || first(below[k]) > 0 && first(below[k]) < end, "its heir is in the group");
            }
            rows.clear(0, end);
            assertArrayEquals(rows.stream().toArray(),
                    IntStream.range(plan.belowStart[g], plan.belowStart[g + 1]).map(b -> plan.below[b]).toArray());
            long width = plan.width(g);
            double all = width * (width / 2.0 + plan.height(g));
            assertTrue(width * (width - 1) / 2 + width * plan.height(g) - filled <= 0.05 * all, "zeros in " + g);
            largest = Math.max(largest, plan.width(g) + plan.height(g));
        }
        assertEquals(stored, plan.blocks);
        assertEquals(operations, plan.operations);
        assertEquals(symmetricOperations, plan.symmetricOperations);
        assertEquals(largest, plan.largestFront);
    }

    private static int groupOf(FrontalPlan plan, int row) {
        int g = 0;
        while (plan.groupStart[g + 1] <= row) {
            g++;
        }
        return g;
    }

    /** What a group leaves waits until the group of its first row takes it up. */
    @ParameterizedTest(name = "{0}")
    @MethodSource("deSolvers.linear.FrontalFactorsTest#nets")
    void whatIsLeftWaitsForItsHeir(String name, BlockPattern pattern) {
        FrontalPlan plan = new FrontalPlan(pattern, Long.MAX_VALUE);
        int[] children = new int[plan.groups];
        int most = 0;
        for (int now = 0; now < plan.groups; now++) {
            int waiting = 0;
            for (int g = 0; g <= now; g++) {
                boolean waits = plan.height(g) > 0 && groupOf(plan, plan.below[plan.belowStart[g]]) > now;
                waiting += waits ? plan.height(g) * plan.height(g) : 0;
            }
            most = Math.max(most, waiting);
            if (plan.height(now) > 0) {
                children[groupOf(plan, plan.below[plan.belowStart[now]])]++;
            }
        }
        assertArrayEquals(children, plan.children);
        assertEquals(most, plan.mostLeft);
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("deSolvers.linear.FrontalFactorsTest#nets")
    void aPlanFitsUpToTheBlocksThatFillIn(String name, BlockPattern pattern) {
        FrontalPlan plan = new FrontalPlan(pattern, Long.MAX_VALUE);
        long filled = 0;
        for (BitSet below : fill(pattern, plan)) {
            filled += below.cardinality();
        }
        assertTrue(new FrontalPlan(pattern, filled).fits);
        assertFalse(new FrontalPlan(pattern, filled - 1).fits);
        assertEquals(0, new FrontalPlan(pattern, filled - 1).groups);
    }

    /** All that touch each other are one group; a chain's rows fill in too little alike; a cloth has some of both. */
    @Test
    void whatFillsInAlikeIsOneGroup() {
        FrontalPlan all = new FrontalPlan(FrontalFactorsTest.grown(40, 40), Long.MAX_VALUE);
        assertEquals(1, all.groups);
        assertEquals(40 * 39 / 2, all.blocks);
        FrontalPlan tree = new FrontalPlan(FrontalFactorsTest.grown(80, 1), Long.MAX_VALUE);
        assertEquals(79, tree.groups, "but for the last two");
        FrontalPlan cloth = new FrontalPlan(FrontalFactorsTest.cloth(40, 40), Long.MAX_VALUE);
        assertTrue(cloth.groups < 650, cloth.groups + " of 1600");     // measured 575
    }

    /**
     * The products of n x n particles grow with n^3, as George proved of dissection; row by row they would grow with
     * n^4. Measured 21.6, 26.0, 28.6 and 29.2 n^3; with a single root instead of eight up to 35.5, and without regard
     * to which of two equal separators halves better up to 31.1.
     */
    @ParameterizedTest
    @ValueSource(ints = {20, 40, 64, 80})
    void aClothTakesProductsThatGrowWithTheCubeOfItsEdge(int n) {
        FrontalPlan plan = new FrontalPlan(FrontalFactorsTest.cloth(n, n), Long.MAX_VALUE);
        double products = plan.symmetricOperations / Math.pow(n, 3);
        assertTrue(products < 30, products + " n^3");
    }
}
