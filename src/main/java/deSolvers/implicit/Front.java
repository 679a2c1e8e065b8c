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
    private final double[][] pivotRow;
    private final double[] block = new double[9];
    private final double[] factor = new double[9];
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
        pivotRow = new double[3][widest];
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
                for (int e = 0; e < 9; e++) {
                    front[row + e / 3][at[k] + e % 3] = a[9 * mirror[s] + e];
                }
                for (int e = 0; e < 9 && !symmetric; e++) {
                    front[at[k] + e / 3][row + e % 3] = a[9 * s + e];
                }
            }
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
            System.arraycopy(right, at, pivotRow[c], k + 3, length);
        }
    }

    /** Subtracts from the rows below a pivot block at row k what its elimination adds to them. */
    void eliminate(int k, double[] inverse, int inverseAt) {
        for (int r = k + 3; r < rows; r += 3) {
            for (int i = 0; i < 3; i++) {
                System.arraycopy(front[r + i], k, block, 3 * i, 3);
            }
            Block3.multiply(block, 0, inverse, inverseAt, factor, 0);
            for (int i = 0; i < 9; i++) {
                factor[i] = -factor[i];
            }
            addPivotRows(front[r], front[r + 1], front[r + 2], pivotRow[0], pivotRow[1], pivotRow[2], factor, k + 3,
                    symmetric ? r + 3 : rows);
        }
    }

    /** Adds f p to three rows; one loop over separate arrays, which the compiler makes vector instructions of. */
    private static void addPivotRows(double[] a, double[] b, double[] c, double[] p, double[] q, double[] r, double[] f,
                                     int from, int to) {
        double f0 = f[0];
        double f1 = f[1];
        double f2 = f[2];
        double f3 = f[3];
        double f4 = f[4];
        double f5 = f[5];
        double f6 = f[6];
        double f7 = f[7];
        double f8 = f[8];
        for (int j = from; j < to; j++) {               // all loads come first: else they might see the stores
            double p0 = p[j];
            double p1 = q[j];
            double p2 = r[j];
            double sumA = a[j];
            double sumB = b[j];
            double sumC = c[j];
            a[j] = Math.fma(f0, p0, Math.fma(f1, p1, Math.fma(f2, p2, sumA)));
            b[j] = Math.fma(f3, p0, Math.fma(f4, p1, Math.fma(f5, p2, sumB)));
            c[j] = Math.fma(f6, p0, Math.fma(f7, p1, Math.fma(f8, p2, sumC)));
        }
    }
}
