package deSolvers.linear;

import java.util.Arrays;
import java.util.Random;
import java.util.stream.LongStream;

/** Random sparse matrices of 3 x 3 blocks, and what they have in common with full ones. */
final class SparseCases {
    private SparseCases() {
    }

    /** The pattern of a square grid whose points touch those next to them and across. */
    static BlockPattern grid(int edge) {
        LongStream.Builder pairs = LongStream.builder();
        for (int i = 0; i < edge * edge; i++) {
            for (int[] step : new int[][] {{0, 1}, {1, 0}, {1, 1}, {1, -1}}) {
                int row = i / edge + step[0];
                int column = i % edge + step[1];
                if (row < edge && column >= 0 && column < edge) {
                    pairs.add(BlockPattern.place(i, row * edge + column));
                }
            }
        }
        return new BlockPattern(edge * edge, pairs.build().toArray());
    }

    /** A pattern of random pairs, some of them twice, and some rows alone. */
    static BlockPattern random(int rows, int pairs, Random random) {
        int[] first = random.ints(pairs, 0, rows).toArray();
        return new BlockPattern(rows, Arrays.stream(first).mapToLong(i -> BlockPattern.place(i,
                (i + 1 + random.nextInt(rows - 1)) % rows)).toArray());
    }

    /** Springs of this stiffness between all that touch, and a mass of 1 on each: positive definite. */
    static BlockMatrix springs(BlockPattern pattern, double stiffness, boolean symmetric, SolverWork work) {
        Random random = new Random(pattern.rows);
        BlockMatrix matrix = new BlockMatrix(pattern, work);
        double[] value = matrix.getValues();
        for (int i = 0; i < pattern.rows; i++) {
            for (int e = 0; e < 9; e += 4) {
                value[9 * pattern.diagonal(i) + e] += 1;
            }
            for (int s = pattern.rowStart(i); s < pattern.rowStart(i + 1); s++) {
                int j = pattern.column(s);
                double[] along = random.doubles(3, -1, 1).toArray();
                for (int e = 0; e < 9 && j > i; e++) {
                    double k = stiffness * along[e / 3] * along[e % 3];
                    value[9 * pattern.diagonal(i) + e] += k;
                    value[9 * pattern.diagonal(j) + e] += k;
                    value[9 * s + e] -= k;
                    value[9 * pattern.find(j, i) + e] -= symmetric ? k : 0.5 * k;
                }
            }
        }
        return matrix;
    }

    /** The same matrix in full, by rows. */
    static double[] full(BlockMatrix matrix) {
        BlockPattern pattern = matrix.getPattern();
        int n = 3 * pattern.rows;
        double[] full = new double[n * n];
        for (int i = 0; i < pattern.rows; i++) {
            for (int s = pattern.rowStart(i); s < pattern.rowStart(i + 1); s++) {
                for (int e = 0; e < 9; e++) {
                    full[(3 * i + e / 3) * n + 3 * pattern.column(s) + e % 3] = matrix.getValues()[9 * s + e];
                }
            }
        }
        return full;
    }

    /** |b - A x| / |b|. */
    static double residual(LinearOperator a, double[] b, double[] x) {
        double[] left = new double[b.length];
        a.apply(x, left);
        for (int i = 0; i < b.length; i++) {
            left[i] = b[i] - left[i];
        }
        return Gmres.norm(left) / Gmres.norm(b);
    }

    static double[] vector(int n) {
        return new Random(n).doubles(n, -1, 1).toArray();
    }
}
