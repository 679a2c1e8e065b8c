package deSolvers.linear;

import java.util.Arrays;

/**
 * The small full matrix in which {@link FrontalFactors} eliminates one group of particles after the other, and what is
 * left of it each time until it is added to another. Of a symmetric matrix only the part right of the diagonal is kept.
 */
final class Front {
    private final BlockPattern pattern;
    private final FrontalPlan plan;
    private final double[][] front;
    private final PivotRows pivotRows;
    // below the pivot block, each as a row; not of a symmetric matrix
    private final double[][] pivotColumns;
    private final int[] at;                             // of each place: where it is in the front
    private final double[] left;
    private int leftEnd;
    private final int[] waiting;                        // the groups that it is left of, the last one on top
    private int waitings;
    private final int[] columns;                        // where its columns are in the front to which they are added
    private final int[] mirror;                         // of each block: the slot of its mirror image
    private final boolean[] lone;                       // of each particle: whether its row has no neighbour
    private double[] a;
    private boolean symmetric;
    private int g;
    private int rows;

    Front(BlockPattern pattern, FrontalPlan plan) {
        this.pattern = pattern;
        this.plan = plan;
        int n = pattern.rows;
        int widest = 3 * plan.largestFront;
        front = new double[widest][widest];
        pivotRows = new PivotRows(front);
        pivotColumns = new double[3][widest];
        at = new int[n];
        left = new double[9 * plan.mostLeft];
        waiting = new int[plan.groups];
        columns = new int[widest];
        lone = new boolean[n];
        mirror = new int[pattern.blocks()];
        int[] next = Arrays.copyOf(pattern.rowStart, n);
        for (int i = 0; i < n; i++) {
            for (int s = pattern.rowStart[i]; s < pattern.rowStart[i + 1]; s++) {
                mirror[s] = next[pattern.column[s]]++;
            }
        }
    }

    /** Takes up a matrix, the values in the pattern. */
    void begin(double[] a, boolean symmetric) {
        this.a = a;
        this.symmetric = symmetric;
        leftEnd = 0;
        waitings = 0;
        findLone();
    }

    /** Finds the rows without a neighbour. */
    private void findLone() {
        for (int i = 0; i < pattern.rows; i++) {
            boolean alone = true;
            for (int s = pattern.rowStart[i]; alone && s < pattern.rowStart[i + 1]; s++) {
                for (int e = 9 * s; alone && pattern.column[s] != i && e < 9 * s + 9; e++) {
                    alone = a[e] == 0;
                }
            }
            lone[i] = alone;
        }
    }

    /** Makes this the front of a group; returns how many rows it has. */
    int assemble(int g) {
        this.g = g;
        rows = 3 * (plan.width(g) + plan.height(g));
        int first = plan.groupStart[g];
        int width = plan.width(g);
        for (int k = 0; k < width; k++) {
            at[first + k] = 3 * k;
        }
        for (int b = plan.belowStart[g], r = 3 * width; b < plan.belowStart[g + 1]; b++, r += 3) {
            at[plan.below[b]] = r;
        }
        for (int r = 0; r < rows; r++) {
            Arrays.fill(front[r], symmetric ? r / 3 * 3 : 0, rows, 0);
        }
        addEntries();
        addLeft();
        return rows;
    }

    /** Adds the matrix's own entries in the rows and columns of the group. */
    private void addEntries() {
        for (int k = plan.groupStart[g]; k < plan.groupStart[g + 1]; k++) {
            int i = plan.order[k];
            for (int s = pattern.rowStart[i]; s < pattern.rowStart[i + 1]; s++) {
                int j = pattern.column[s];
                if (plan.place[j] < k || symmetric && j != i && (lone[i] || lone[j])) {
                    continue;
                }
                int row = at[plan.place[j]];
                copyBlock(9 * s, at[k], row);
                if (!symmetric) {
                    copyBlock(9 * mirror[s], row, at[k]);
                }
            }
        }
    }

    private void copyBlock(int from, int row, int column) {
        for (int c = 0; c < 3; c++) {
            System.arraycopy(a, from + 3 * c, front[row + c], column, 3);
        }
    }

    /** Adds what the fronts of the group's children left. */
    private void addLeft() {
        for (int c = 0; c < plan.children[g]; c++) {
            int child = waiting[--waitings];
            int height = 3 * plan.height(child);
            leftEnd -= height * height;
            for (int b = plan.belowStart[child], r = 0; r < height; b++, r += 3) {
                columns[r] = at[plan.below[b]];
                columns[r + 1] = columns[r] + 1;
                columns[r + 2] = columns[r] + 2;
            }
            for (int r = 0, from = leftEnd; r < height; r++, from += height) {
                double[] row = front[columns[r]];
                for (int e = symmetric ? r / 3 * 3 : 0; e < height; e++) {
                    row[columns[e]] += left[from + e];
                }
            }
        }
    }

    /** Puts by what is left of the front. */
    void keepLeft() {
        int height = 3 * plan.height(g);
        int width = 3 * plan.width(g);
        if (height > 0) {
            for (int r = 0; r < height; r++, leftEnd += height) {
                int first = symmetric ? r / 3 * 3 : 0;
                System.arraycopy(front[width + r], width + first, left, leftEnd + first, height - first);
            }
            waiting[waitings++] = g;
        }
    }

    /** Copies the pivot block at row k. */
    void copyPivot(int k, double[] block) {
        for (int c = 0; c < 3; c++) {
            System.arraycopy(front[k + c], k, block, 3 * c, 3);
        }
    }

    /** Copies the rows of the pivot block at row k, right of it. */
    void copyRows(int k, double[] right, int to) {
        int length = rows - k - 3;
        for (int c = 0; c < 3; c++) {
            System.arraycopy(front[k + c], k + 3, right, to + c * length, length);
        }
    }

    /**
     * Copies the columns of the pivot block at row k, below it, each into a row; for a matrix that is not symmetric.
     */
    void copyColumns(int k, double[] below, int to) {
        int length = rows - k - 3;
        for (int r = k + 3; r < rows; r++) {
            for (int c = 0; c < 3; c++) {
                pivotColumns[c][r] = front[r][k + c];
            }
        }
        for (int c = 0; c < 3; c++) {
            System.arraycopy(pivotColumns[c], k + 3, below, to + c * length, length);
        }
    }

    /**
     * Subtracts from the rows below a pivot block at row k what its elimination adds to them. Its columns have been
     * copied, unless the matrix is symmetric. Blocks are eliminated in pairs; of the first one only what the second
     * needs is subtracted before both are.
     */
    void eliminate(int k, double[] inverse, int inverseAt) {
        boolean second = k % 6 == 3;
        pivotRows.take(k, second, symmetric ? front : pivotColumns, symmetric ? k : 0, rows, inverse, inverseAt);
        if (second) {
            for (int r = k + 3; r < rows; r++) {
                pivotRows.addBoth(r, symmetric ? r / 3 * 3 : k + 3, rows);
            }
        } else if (k + 3 < 3 * plan.width(g)) {
            for (int r = k + 3; r < k + 6; r++) {
                pivotRows.addFirst(r, k + 3, rows);
            }
            for (int r = k + 6; r < rows && !symmetric; r++) {
                pivotRows.addFirst(r, k + 3, k + 6);
            }
        } else {
            for (int r = k + 3; r < rows; r++) {
                pivotRows.addFirst(r, symmetric ? r / 3 * 3 : k + 3, rows);
            }
        }
    }
}
