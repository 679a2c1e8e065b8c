package deSolvers.implicit;

import java.util.Arrays;

/**
 * The small full matrix in which {@link FrontalFactors} eliminates one group of particles after the other, and what is left of
 * it each time until it is added to another. Of a symmetric matrix only the part below the diagonal is kept.
 */
final class Front {
    private final BlockPattern pattern;
    private final FrontalPlan plan;
    private final double[][] front;
    private final PivotRows pivotRows;
    private final double[] block = new double[9];
    private final double[] minusInverse = new double[9];
    private final double[] factor = new double[9];
    private final double[] next = new double[9];
    private final double[] product = new double[9];
    private final double[] firstFactors;                // of each row, where the pivot block is the first of two
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
        int n = plan.fits ? pattern.rows : 0;
        int widest = 3 * plan.largestFront;
        front = new double[widest][widest];
        pivotRows = new PivotRows(widest);
        firstFactors = new double[3 * widest];
        at = new int[n];
        left = new double[9 * plan.mostLeft];
        waiting = new int[plan.groups];
        columns = new int[widest];
        lone = new boolean[n];
        mirror = new int[n == 0 ? 0 : pattern.blocks()];
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
            Arrays.fill(front[r], 0, symmetric ? r / 3 * 3 + 3 : rows, 0);
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
                copyBlock(9 * mirror[s], row, at[k]);
                if (!symmetric) {
                    copyBlock(9 * s, at[k], row);
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
                for (int e = 0, end = symmetric ? r / 3 * 3 + 3 : height; e < end; e++) {
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
                System.arraycopy(front[width + r], width, left, leftEnd, symmetric ? r / 3 * 3 + 3 : height);
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

    /** Copies the columns of the pivot block at row k, below it, each into a row. */
    void copyColumns(int k, double[] transposed, int to) {
        int length = rows - k - 3;
        for (int r = k + 3, e = to; r < rows; r++, e++) {
            double[] row = front[r];
            transposed[e] = row[k];
            transposed[e + length] = row[k + 1];
            transposed[e + 2 * length] = row[k + 2];
        }
    }

    /** Copies the rows of the pivot block at row k, right of it, unless the matrix is symmetric: they are there then. */
    void copyRows(int k, double[] right, int to) {
        int length = rows - k - 3;
        for (int c = 0, at = to; c < 3; c++, at += length) {
            if (!symmetric) {
                System.arraycopy(front[k + c], k + 3, right, at, length);
            }
            System.arraycopy(right, at, pivotRows.get(k % 6 + c), k + 3, length);
        }
    }

    /**
     * Subtracts from the rows below a pivot block at row k what its elimination adds to them. Blocks are eliminated in pairs;
     * of the first one only what the second needs is subtracted before both are.
     */
    void eliminate(int k, double[] inverse, int inverseAt) {
        for (int e = 0; e < 9; e++) {
            minusInverse[e] = -inverse[inverseAt + e];
        }
        if (k % 6 == 3) {
            eliminatePair(k);
        } else if (k + 3 < 3 * plan.width(g)) {
            eliminateFirst(k);
        } else {
            eliminateSingle(k);
        }
    }

    private void eliminateSingle(int k) {
        for (int r = k + 3; r < rows; r += 3) {
            findFactor(r, k, factor, 0);
            for (int c = 0; c < 3; c++) {
                pivotRows.add(front[r + c], factor, 3 * c, k + 3, symmetric ? r + 3 : rows);
            }
        }
    }

    /** The columns of the second pivot block, and its rows; the factors are kept. */
    private void eliminateFirst(int k) {
        for (int c = 0; c < 3; c++) {
            System.arraycopy(pivotRows.get(c), k + 3, next, 3 * c, 3);
        }
        for (int r = k + 3; r < rows; r += 3) {
            findFactor(r, k, firstFactors, 3 * r);
            Block3.multiply(firstFactors, 3 * r, next, 0, product, 0);
            for (int c = 0; c < 3; c++) {
                double[] row = front[r + c];
                row[k + 3] += product[3 * c];
                row[k + 4] += product[3 * c + 1];
                row[k + 5] += product[3 * c + 2];
            }
        }
        for (int r = k + 3; r < k + 6 && !symmetric; r++) {
            pivotRows.add(front[r], firstFactors, 3 * r, k + 6, rows);
        }
    }

    private void eliminatePair(int k) {
        for (int r = k + 3; r < rows; r += 3) {
            findFactor(r, k, factor, 0);
            for (int c = 0; c < 3; c++) {
                pivotRows.add(front[r + c], firstFactors, 3 * (r + c), factor, 3 * c, k + 3, symmetric ? r + 3 : rows);
            }
        }
    }

    /** What the pivot block's rows are to be multiplied by before they are added to three others. */
    private void findFactor(int r, int k, double[] factor, int at) {
        for (int c = 0; c < 3; c++) {
            System.arraycopy(front[r + c], k, block, 3 * c, 3);
        }
        Block3.multiply(block, 0, minusInverse, 0, factor, at);
    }
}
