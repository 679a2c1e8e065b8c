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
        int[] start = new int[rows + 1];
        for (int p = 0; p < pairs; p++) {
            start[first[p] + 1]++;
            start[second[p] + 1]++;
        }
        for (int i = 0; i < rows; i++) {
            start[i + 1] += start[i] + 1;               // and the diagonal
        }
        int[] filled = Arrays.copyOf(start, rows);
        int[] columns = new int[start[rows]];
        for (int i = 0; i < rows; i++) {
            columns[filled[i]++] = i;
        }
        for (int p = 0; p < pairs; p++) {
            columns[filled[first[p]]++] = second[p];
            columns[filled[second[p]]++] = first[p];
        }
        rowStart = new int[rows + 1];
        int end = 0;
        for (int i = 0; i < rows; i++) {
            Arrays.sort(columns, start[i], start[i + 1]);
            rowStart[i] = end;
            for (int at = start[i]; at < start[i + 1]; at++) {
                if (at == start[i] || columns[at] != columns[at - 1]) {
                    columns[end++] = columns[at];
                }
            }
        }
        rowStart[rows] = end;
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
