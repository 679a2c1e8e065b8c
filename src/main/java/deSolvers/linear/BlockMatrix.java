package deSolvers.linear;

import java.util.Arrays;

/** A sparse matrix of 3 x 3 blocks; its pattern is symmetric, its values need not be. */
public final class BlockMatrix implements LinearOperator {
    /** Blocks that are transposes of each other in exact arithmetic differ by less than this part of the diagonal. */
    private static final double SYMMETRIC = 1e-13;

    private final BlockPattern pattern;
    private final double[] values;
    private final SolverWork work;

    /**
     * A matrix of zeros.
     *
     * @param pattern the positions of its blocks
     * @param work    counts the products
     */
    public BlockMatrix(BlockPattern pattern, SolverWork work) {
        this.pattern = pattern;
        this.work = work;
        values = new double[9 * pattern.countBlocks()];
    }

    /** @return the positions of its blocks */
    public BlockPattern getPattern() {
        return pattern;
    }

    /**
     * @return the blocks in the pattern's order, nine doubles by rows each; the matrix's own array, to be written into
     */
    public double[] getValues() {
        return values;
    }

    @Override
    public void apply(double[] x, double[] y) {
        work.blockOperations += pattern.countBlocks();
        int[] column = pattern.column;
        for (int i = 0, yAt = 0; i < pattern.rows; i++, yAt += 3) {
            double y0 = 0;
            double y1 = 0;
            double y2 = 0;
            for (int s = pattern.rowStart[i], end = pattern.rowStart[i + 1]; s < end; s++) {
                int at = 9 * s;
                int xAt = 3 * column[s];
                double x0 = x[xAt];
                double x1 = x[xAt + 1];
                double x2 = x[xAt + 2];
                y0 += values[at] * x0 + values[at + 1] * x1 + values[at + 2] * x2;
                y1 += values[at + 3] * x0 + values[at + 4] * x1 + values[at + 5] * x2;
                y2 += values[at + 6] * x0 + values[at + 7] * x1 + values[at + 8] * x2;
            }
            y[yAt] = y0;
            y[yAt + 1] = y1;
            y[yAt + 2] = y2;
        }
    }

    /**
     * Multiplies by the absolute values of the entries.
     *
     * @param x a vector of no negative numbers
     * @param y receives |A| x
     */
    public void applyAbsolute(double[] x, double[] y) {
        for (int i = 0; i < pattern.rows; i++) {
            for (int c = 0; c < 3; c++) {
                double sum = 0;
                for (int s = pattern.rowStart[i]; s < pattern.rowStart[i + 1]; s++) {
                    for (int b = 0; b < 3; b++) {
                        sum += Math.abs(values[9 * s + 3 * c + b]) * x[3 * pattern.column[s] + b];
                    }
                }
                y[3 * i + c] = sum;
            }
        }
    }

    /** Sets the blocks of row i to 0. */
    public void clearRow(int i) {
        Arrays.fill(values, 9 * pattern.rowStart[i], 9 * pattern.rowStart[i + 1], 0);
    }

    /**
     * Multiplies a row of blocks from the left.
     *
     * @param i    the row
     * @param by   a block
     * @param room work space for one block
     */
    public void transformRow(int i, double[] by, double[] room) {
        for (int s = pattern.rowStart[i]; s < pattern.rowStart[i + 1]; s++) {
            System.arraycopy(values, 9 * s, room, 0, 9);
            Arrays.fill(values, 9 * s, 9 * s + 9, 0);
            Block3.addBlockProduct(1, by, 0, room, 0, false, values, 9 * s);
        }
    }

    /** @return whether the matrix is its own transpose, up to round-off */
    public boolean isSymmetric() {
        for (int i = 0; i < pattern.rows; i++) {
            double scale = SYMMETRIC * trace(i);
            for (int s = pattern.rowStart[i]; s <= pattern.diagonal[i]; s++) {
                int mirror = pattern.find(pattern.column[s], i);
                for (int e = 0; e < 9; e++) {
                    if (Math.abs(values[9 * s + e] - values[9 * mirror + e % 3 * 3 + e / 3]) > scale) {
                        return false;
                    }
                }
            }
        }
        return true;
    }

    /** The sum of the sizes of a row's three diagonal entries. */
    private double trace(int i) {
        int at = 9 * pattern.diagonal[i];
        return Math.abs(values[at]) + Math.abs(values[at + 4]) + Math.abs(values[at + 8]);
    }
}
