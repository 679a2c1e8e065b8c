package deSolvers.linear;

import java.util.Arrays;
import java.util.stream.IntStream;
import java.util.stream.LongStream;

/**
 * The sparsity pattern of a matrix of 3 x 3 blocks: the positions of its entries, row by row, with ascending columns.
 * It is symmetric and always has the diagonal.
 */
public final class BlockPattern {
    final int rows;
    final int[] rowStart;
    final int[] column;
    final int[] diagonal;

    /**
     * The pattern with the blocks (i, j) and (j, i) of all pairs, and the diagonal.
     *
     * @param rows  rows of blocks
     * @param pairs the pairs, made by {@link #place}; some may be there twice
     */
    public BlockPattern(int rows, long... pairs) {
        this.rows = rows;
        LongStream beside = Arrays.stream(pairs).flatMap(pair -> LongStream.of(pair,
                place((int) pair, (int) (pair >> Integer.SIZE))));
        long[] places = LongStream.concat(IntStream.range(0, rows).mapToLong(i -> place(i, i)), beside)
                .sorted().distinct().toArray();
        rowStart = new int[rows + 1];
        for (int slot = 0; slot < places.length; slot++) {
            rowStart[(int) (places[slot] >> Integer.SIZE) + 1] = slot + 1;
        }
        column = Arrays.stream(places).mapToInt(place -> (int) place).toArray();
        diagonal = IntStream.range(0, rows).map(i -> find(i, i)).toArray();
    }

    /** @return the pair of a row and a column as one number; sorted by it, places are in the order of slots */
    public static long place(int row, int column) {
        return (long) row << Integer.SIZE | column;
    }

    /**
     * @param i a row
     * @return the slot of its diagonal block
     */
    public int diagonal(int i) {
        return diagonal[i];
    }

    /**
     * @param i a row
     * @return its first slot; the last one is right before that of row i + 1
     */
    public int rowStart(int i) {
        return rowStart[i];
    }

    /**
     * @param slot a slot
     * @return the column of its block
     */
    public int column(int slot) {
        return column[slot];
    }

    /** @return the number of blocks */
    public int countBlocks() {
        return column.length;
    }

    /** @return the slot of block (i, j); negative if it is not in the pattern */
    public int find(int i, int j) {
        return Arrays.binarySearch(column, rowStart[i], rowStart[i + 1], j);
    }
}
