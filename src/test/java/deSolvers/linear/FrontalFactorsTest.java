package deSolvers.linear;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Sparse elimination against a full matrix, on nets of many shapes, and what it costs. */
class FrontalFactorsTest {
    private static final long MOST = 4_000_000;

    /** A net of particles: pairs that are joined. */
    private static BlockPattern net(int n, List<int[]> pairs) {
        int[] first = pairs.stream().mapToInt(pair -> pair[0]).toArray();
        int[] second = pairs.stream().mapToInt(pair -> pair[1]).toArray();
        return new BlockPattern(n, first.length, first, second);
    }

    /** As many particles as a cloth has, joined to their neighbours, across, and to the next but one. */
    static BlockPattern cloth(int width, int height) {
        List<int[]> pairs = new ArrayList<>();
        for (int row = 0; row < height; row++) {
            for (int column = 0; column < width; column++) {
                for (int[] joint : new int[][] {{0, 1}, {1, 0}, {1, 1}, {1, -1}, {0, 2}, {2, 0}}) {
                    int r = row + joint[0];
                    int c = column + joint[1];
                    if (r < height && c >= 0 && c < width) {
                        pairs.add(new int[] {row * width + column, r * width + c});
                    }
                }
            }
        }
        return net(width * height, pairs);
    }

    /**
     * Each particle joined to that many of those before it: 1 makes a tree; all of them, where everything touches all.
     */
    static BlockPattern grown(int n, int joints) {
        Random random = new Random(5);
        List<int[]> pairs = new ArrayList<>();
        for (int i = 1; i < n; i++) {
            for (int k = 0; k < joints; k++) {
                pairs.add(new int[] {i, joints < n ? random.nextInt(i) : k % i});
            }
        }
        return net(n, pairs);
    }

    /** A chain, a ring, and some that are alone. */
    private static BlockPattern pieces() {
        List<int[]> pairs = new ArrayList<>();
        for (int i = 0; i < 20; i++) {
            pairs.add(new int[] {i, i + 1});
        }
        for (int i = 30; i < 45; i++) {
            pairs.add(new int[] {i, i == 44 ? 30 : i + 1});
        }
        return net(50, pairs);
    }

    /** Sixty rings of six; more sets wait to be cut than there is room for at first. */
    private static BlockPattern rings() {
        List<int[]> pairs = new ArrayList<>();
        for (int i = 0; i < 360; i++) {
            pairs.add(new int[] {i, i % 6 == 5 ? i - 5 : i + 1});
        }
        return net(360, pairs);
    }

    static Stream<Arguments> nets() {
        return Stream.of(Arguments.of("cloth", cloth(12, 9)), Arguments.of("strip", cloth(40, 3)),
                Arguments.of("tree", grown(80, 1)), Arguments.of("random", grown(70, 3)),
                Arguments.of("all to all", grown(40, 40)), Arguments.of("pieces", pieces()),
                Arguments.of("rings", rings()),
                Arguments.of("one", net(1, List.of())), Arguments.of("none", net(0, List.of())));
    }

    /** Random blocks; symmetric, the matrix is indefinite, and the rows of the particles 0 and 7 are held. */
    private static double[] values(BlockPattern pattern, boolean symmetric, Random random) {
        double[] a = new double[9 * pattern.blocks()];
        for (int i = 0; i < pattern.rows; i++) {
            for (int s = pattern.rowStart[i]; s < pattern.rowStart[i + 1]; s++) {
                int j = pattern.column[s];
                int mirror = pattern.find(j, i);
                for (int e = 0; e < 9; e++) {
                    double value = random.nextDouble() - 0.5;
                    a[9 * s + e] = value;
                    if (symmetric) {
                        a[9 * mirror + 3 * (e % 3) + e / 3] = value;
                    }
                }
            }
            for (int d = 0; d < 9; d += 4) {
                a[9 * pattern.diagonal[i] + d] += i % 3 == 1 ? -9 : 9;
            }
        }
        for (int i = 0; symmetric && i < pattern.rows; i += 7) {
            for (int s = pattern.rowStart[i]; i < 8 && s < pattern.rowStart[i + 1]; s++) {
                for (int e = 0; e < 9; e++) {
                    a[9 * s + e] = pattern.column[s] == i && e % 4 == 0 ? 1 : 0;
                }
            }
        }
        return a;
    }

    private static DMatrixRMaj full(BlockPattern pattern, double[] a) {
        DMatrixRMaj full = new DMatrixRMaj(3 * pattern.rows, 3 * pattern.rows);
        for (int i = 0; i < pattern.rows; i++) {
            for (int s = pattern.rowStart[i]; s < pattern.rowStart[i + 1]; s++) {
                for (int e = 0; e < 9; e++) {
                    full.set(3 * i + e / 3, 3 * pattern.column[s] + e % 3, a[9 * s + e]);
                }
            }
        }
        return full;
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("nets")
    void theFactorsSolveTheSystem(String name, BlockPattern pattern) {
        Random random = new Random(17);
        FrontalFactors factors = new FrontalFactors(new ImplicitWork.Counter());
        assertTrue(factors.fits(pattern, MOST));
        for (int round = 0; round < 4; round++) {
            boolean symmetric = round % 2 == 0;
            double[] a = values(pattern, symmetric, random);
            double[] b = new double[3 * pattern.rows];
            for (int i = 0; i < b.length; i++) {        // nothing where particles are held: their columns are left out
                b[i] = symmetric && (i / 3 == 0 || i / 3 == 7) ? 0 : random.nextDouble() - 0.5;
            }
            assertTrue(factors.factorise(a, symmetric), name);
            double[] x = new double[b.length];
            factors.apply(b, x);
            DMatrixRMaj expected = new DMatrixRMaj(b.length, 1);
            double largest = 0;
            assertTrue(b.length == 0 || CommonOps_DDRM.solve(full(pattern, a), DMatrixRMaj.wrap(b.length, 1, b),
                    expected));
            for (int i = 0; i < b.length; i++) {
                largest = Math.max(largest, Math.abs(expected.get(i) - x[i]));
            }
            assertTrue(largest < 1e-15, name + ": " + largest);         // measured at most 1.4e-16
        }
    }

    @Test
    void aMatrixWithASingularBlockIsRefused() {
        BlockPattern pattern = cloth(5, 5);
        FrontalFactors factors = new FrontalFactors(new ImplicitWork.Counter());
        assertTrue(factors.fits(pattern, MOST));
        double[] a = values(pattern, true, new Random(3));
        assertTrue(factors.factorise(a, true));
        Arrays.fill(a, 0);
        assertFalse(factors.factorise(a, true));
    }

    @Test
    void factorsThatAreTooLargeAreNotMade() {
        FrontalFactors factors = new FrontalFactors(new ImplicitWork.Counter());
        assertFalse(factors.fits(cloth(12, 9), 1000));
        assertTrue(factors.fits(cloth(12, 9), 10_000));
    }

    /** Half the products with a symmetric matrix; and no more fill-in than the order of minimum degree has. */
    @Test
    void aClothIsEliminatedWithLittleFillIn() {
        ImplicitWork.Counter work = new ImplicitWork.Counter();
        FrontalFactors factors = new FrontalFactors(work);
        BlockPattern pattern = cloth(64, 64);
        assertTrue(factors.fits(pattern, MOST));
        double[] a = values(pattern, true, new Random(1));
        assertTrue(factors.factorise(a, true));
        double once = work.blockOperations;
        assertTrue(factors.factorise(a, false));
        assertEquals(2 * once, work.blockOperations - once, 0.1 * once);
        // Approximate minimum degree, by AMDJ: 193,718 blocks below the diagonal and 7.8e6 products of blocks. Measured
        // here
        // 8.71e6 products, and 413,770 blocks on both sides of the diagonal and on it.
        assertTrue(once < 9.5e6, once + " products");
        assertTrue(factors.blocks() < 450_000, factors.blocks() + " blocks");
    }

    /** What hangs by one joint is taken off from its ends, in whatever order it was numbered, and fills in nothing. */
    @Test
    void treesFillInNothing() {
        BlockPattern tree = grown(3000, 1);
        boolean[] gone = new boolean[tree.rows];
        for (int i : NestedDissection.order(tree)) {
            int left = 0;
            for (int s = tree.rowStart[i]; s < tree.rowStart[i + 1]; s++) {
                left += gone[tree.column[s]] || tree.column[s] == i ? 0 : 1;
            }
            gone[i] = true;
            assertTrue(left <= 1, "particle " + i + " touches " + left + " that are left");
        }
    }

    /** One factorisation, and a product for each block of the factors where they are applied. */
    @Test
    void theWorkIsCounted() {
        ImplicitWork.Counter work = new ImplicitWork.Counter();
        FrontalFactors factors = new FrontalFactors(work);
        BlockPattern pattern = grown(40, 40);           // all touch all: nothing but full triangles
        assertTrue(factors.fits(pattern, MOST));
        double[] a = values(pattern, false, new Random(9));
        assertTrue(factors.factorise(a, false), "the first, without a symmetric one before");
        assertEquals(1, work.factorisations);
        long products = 0;
        for (long below = 0; below < 40; below++) {
            products += below + below * below;          // by the pivot's inverse, and with each other
        }
        assertEquals(products, work.blockOperations);
        assertEquals(3 * products, factors.cost(), "each is three of nine entries with three");
        factors.apply(new double[120], new double[120]);
        assertEquals(40 * 40, factors.blocks());
        assertEquals(products + 40 * 40, work.blockOperations);
    }

    /** What is not connected is ordered by itself, whoever else is there: two cloths fill in twice as much as one. */
    @Test
    void piecesAreOrderedByThemselves() {
        BlockPattern one = cloth(24, 24);
        List<int[]> pairs = new ArrayList<>();
        for (int i = 0; i < one.rows; i++) {
            for (int s = one.diagonal[i] + 1; s < one.rowStart[i + 1]; s++) {
                pairs.add(new int[] {2 * i, 2 * one.column[s]});
                pairs.add(new int[] {2 * i + 1, 2 * one.column[s] + 1});
            }
        }
        FrontalPlan alone = new FrontalPlan(one, MOST);
        FrontalPlan both = new FrontalPlan(net(2 * one.rows, pairs), MOST);
        assertEquals(2 * alone.blocks, both.blocks);
        assertEquals(2 * alone.operations, both.operations);
        assertEquals(alone.largestFront, both.largestFront);
    }
}
