package deSolvers.linear;

import java.util.Arrays;

/**
 * Where a sparse matrix of 3 x 3 blocks has entries: row by row the columns in ascending order, always with the
 * diagonal and always symmetric. Made from the pairs (i, j) that a source named, in the order in which it named them;
 * since it names them in the same order every time, each pair's places are looked up only once.
 */
public final class BlockPattern {
    public final int rows;
    public final int[] rowStart;
    public final int[] column;
    public final int[] diagonal;
    private final int pairs;
    private final int[] first;
    private final int[] second;
    /** Slots of (i, j) and (j, i) for each pair. */
    public final int[] slot;
    public final int[] mirrorSlot;

    /** Finds the pattern of the given pairs; the arrays are read from 0 to pairs - 1 and copied. */
    BlockPattern(int rows, int pairs, int[] first, int[] second) {
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

    /** Whether pair number p is (i, j). */
    boolean isPair(int p, int i, int j) {
        return p < pairs && first[p] == i && second[p] == j;
    }

    int pairs() {
        return pairs;
    }

    /** The number of blocks. */
    public int blocks() {
        return column.length;
    }

    /** The slot of a block that is in the pattern. */
    int find(int i, int j) {
        return Arrays.binarySearch(column, rowStart[i], rowStart[i + 1], j);
    }

    /** Multiplies a row of values from the left with a 3 x 3 matrix; {@code work} has room for 9. */
    public void transformRow(int i, double[] matrix, double[] values, double[] work) {
        for (int s = rowStart[i]; s < rowStart[i + 1]; s++) {
            Block3.multiply(matrix, 0, values, 9 * s, work, 0);
            System.arraycopy(work, 0, values, 9 * s, 9);
        }
    }
}
