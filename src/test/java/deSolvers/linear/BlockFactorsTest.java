package deSolvers.linear;

import static deSolvers.problems.Bounds.assertBelow;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import java.util.stream.IntStream;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class BlockFactorsTest {
    private final SolverWork work = new SolverWork();

    private double[] solve(BlockMatrix matrix, boolean symmetric, double[] b) {
        BlockFactors factors = new BlockFactors(matrix.getPattern(), work);
        assertTrue(factors.factorise(matrix, symmetric));
        double[] x = new double[b.length];
        factors.apply(b, x);
        return x;
    }

    private double[] solveInFull(BlockMatrix matrix, double[] b) {
        int n = b.length;
        DMatrixRMaj x = new DMatrixRMaj(n, 1);
        DMatrixRMaj full = DMatrixRMaj.wrap(n, n, SparseCases.full(matrix));
        assertTrue(CommonOps_DDRM.solve(full, DMatrixRMaj.wrap(n, 1, b), x));
        return x.data;
    }

    /** Against the full matrix; at a condition of 100 the solutions differ by at most 3e-15 (measured). */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void solutionsAreThoseOfTheFullMatrix(boolean symmetric) {
        Random random = new Random(7);
        for (int rows : new int[] {2, 3, 10, 60}) {
            BlockMatrix matrix = SparseCases.springs(SparseCases.random(rows, 2 * rows, random), 10, symmetric, work);
            assertEquals(symmetric, matrix.isSymmetric());
            double[] b = SparseCases.vector(3 * rows);
            assertArrayEquals(solveInFull(matrix, b), solve(matrix, symmetric, b), 3e-14, rows + " rows");
        }
    }

    /** The two ways to factorise a symmetric matrix agree, and the symmetric one takes half the products. */
    @Test
    void aSymmetricMatrixTakesHalfTheWork() {
        BlockMatrix matrix = SparseCases.springs(SparseCases.grid(12), 10, true, work);
        BlockFactors factors = new BlockFactors(matrix.getPattern(), work);
        double[] b = SparseCases.vector(432);
        assertArrayEquals(solve(matrix, false, b), solve(matrix, true, b), 1e-13);
        assertEquals(2 * factors.products(true), factors.products(false));
    }

    /** Factors serve any number of matrices of one pattern, symmetric ones and others in turn. */
    @Test
    void factorsCanBeMadeAnew() {
        BlockPattern pattern = SparseCases.grid(6);
        BlockFactors factors = new BlockFactors(pattern, work);
        double[] b = SparseCases.vector(108);
        double[] x = new double[108];
        for (boolean symmetric : new boolean[] {true, false, true, false}) {
            BlockMatrix matrix = SparseCases.springs(pattern, symmetric ? 10 : 1000, symmetric, work);
            assertTrue(factors.factorise(matrix, symmetric));
            factors.apply(b, x);
            assertTrue(SparseCases.residual(matrix, b, x) < 1e-13);
        }
    }

    @Test
    void aSingularDiagonalBlockIsNoticed() {
        BlockMatrix zero = new BlockMatrix(SparseCases.grid(2), work);
        assertFalse(new BlockFactors(zero.getPattern(), work).factorise(zero, true));
    }

    /** Every row has one place in the order, whatever the pattern is: in pieces, a clique, a chain. */
    @Test
    void nestedDissectionOrdersEveryRowOnce() {
        Random random = new Random(1);
        for (int rows : new int[] {2, 5, 17, 200}) {
            for (int pairs : new int[] {0, 1, rows / 2, 3 * rows, 20 * rows}) {
                int[] order = NestedDissection.order(SparseCases.random(rows, pairs, random));
                Arrays.sort(order);
                assertArrayEquals(IntStream.range(0, rows).toArray(), order, rows + " rows, " + pairs + " pairs");
            }
        }
        assertEquals(0, NestedDissection.order(new BlockPattern(0)).length);
    }

    /**
     * A grid of n points fills in as n log n, and its elimination takes n^1.5 products. In the given order it would be
     * n^1.5 and n^2. Measured exponents from 32 x 32 to 128 x 128: 1.19 and 1.52.
     */
    @Test
    void aGridFillsInAsTheoryPromises() {
        BlockFactors small = new BlockFactors(SparseCases.grid(32), work);
        BlockFactors large = new BlockFactors(SparseCases.grid(128), work);
        double fill = StrictMath.log((double) large.blocks() / small.blocks()) / StrictMath.log(16);
        double products = StrictMath.log((double) large.products(true) / small.products(true)) / StrictMath.log(16);
        assertBelow(1.25, fill);
        assertBelow(1.6, products);
    }

    /**
     * A chain has no loops: cut by single links, it keeps fewer than three blocks below the diagonal for each (measured
     * 2.6).
     */
    @Test
    void aChainFillsInLittle() {
        int n = 1000;
        BlockPattern chain = new BlockPattern(n, IntStream.range(0, n - 1)
                .mapToLong(i -> BlockPattern.place(i, i + 1)).toArray());
        assertBelow(7 * n, new BlockFactors(chain, work).blocks());
    }

    /** A matrix whose factors would take gigabytes is refused before they are made. */
    @Test
    void factorsThatDoNotFitAreNotMade() {
        assertFalse(new BlockFactors(SparseCases.random(4000, 60_000, new Random(3)), work).isFit());
        assertTrue(new BlockFactors(SparseCases.grid(40), work).isFit());
    }
}
