package deSolvers.linear;

import java.util.Arrays;

/**
 * The sparsity pattern of a matrix of 3 x 3 blocks: the positions of its entries, row by row, with ascending columns.
 * It is symmetric and always has the diagonal. It is made from a list of pairs (i, j), and knows the slots of each pair
 * by its number in that list.
 */
public final class BlockPattern {
    final int rows;
    final int[] rowStart;
    final int[] column;
    final int[] diagonal;
    private final int pairs;
    private final int[] first;
    private final int[] second;
    private final int[] slot;
    private final int[] mirrorSlot;

    /**
     * The pattern with the blocks (i, j) and (j, i) of all pairs, and the diagonal.
     *
     * @param rows   rows of blocks
     * @param pairs  the number of pairs; the first entries of the arrays, so many, are copied
     * @param first  i of each pair
     * @param second j of each pair
     */
    public BlockPattern(int rows, int pairs, int[] first, int[] second) {
        this.rows = rows;
        this.pairs = pairs;
        this.first = Arrays.copyOf(first, pairs);
        this.second = Arrays.copyOf(second, pairs);
        long[] places = new long[rows + 2 * pairs];     // of all blocks, some twice: row, then column
        for (int i = 0; i < rows; i++) {
            places[i] = place(i, i);
        }
        for (int p = 0; p < pairs; p++) {
            places[rows + 2 * p] = place(first[p], second[p]);
            places[rows + 2 * p + 1] = place(second[p], first[p]);
        }
        Arrays.sort(places);
        rowStart = new int[rows + 1];
        int[] columns = new int[places.length];
        int end = 0;
        for (int k = 0; k < places.length; k++) {
            if (k == 0 || places[k] != places[k - 1]) {
                columns[end++] = (int) places[k];
                rowStart[(int) (places[k] >> Integer.SIZE) + 1] = end;
            }
        }
        column = Arrays.copyOf(columns, end);
        diagonal = new int[rows];
        for (int i = 0; i < rows; i++) {
            diagonal[i] = find(i, i);
        }
        slot = new int[pairs];
        mirrorSlot = new int[pairs];
        for (int p = 0; p < pairs; p++) {
            slot[p] = find(first[p], second[p]);
            mirrorSlot[p] = find(second[p], first[p]);
        }
    }

    private static long place(int row, int column) {
        return (long) row << Integer.SIZE | column;
    }

    /**
     * @param p a number
     * @param i a row
     * @param j a column
     * @return whether pair number p is (i, j)
     */
    public boolean isPair(int p, int i, int j) {
        return p < pairs && first[p] == i && second[p] == j;
    }

    /** @return the number of pairs from which the pattern was made */
    public int getPairs() {
        return pairs;
    }

    /** @return the number of rows of blocks */
    public int getRows() {
        return rows;
    }

    /**
     * @param p the number of a pair
     * @return the slot of its block (i, j)
     */
    public int slot(int p) {
        return slot[p];
    }

    /**
     * @param p the number of a pair
     * @return the slot of its block (j, i)
     */
    public int mirrorSlot(int p) {
        return mirrorSlot[p];
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
    public int blocks() {
        return column.length;
    }

    /** The slot of a block that is in the pattern. */
    int find(int i, int j) {
        return Arrays.binarySearch(column, rowStart[i], rowStart[i + 1], j);
    }
}
