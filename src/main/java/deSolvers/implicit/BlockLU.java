package deSolvers.implicit;

import edu.ufl.cise.amd.tdouble.Damd_order;
import java.util.Arrays;

/**
 * A = L U of a sparse matrix of 3 x 3 blocks with a symmetric pattern, eliminated in approximate-minimum-degree order. The
 * elimination keeps to that order and does not pivot outside the diagonal blocks; GMRES, which uses the factors as its
 * preconditioner, makes good what little accuracy that costs.
 *
 * <p>Source: P. R. Amestoy, T. A. Davis, I. S. Duff (1996), SIAM J. Matrix Anal. Appl. 17, 886, for the order; T. A. Davis,
 * <i>Direct Methods for Sparse Linear Systems</i>, SIAM 2006, for elimination trees.
 */
final class BlockLU implements LinearOperator {
    private final ImplicitWork.Counter work;
    private BlockPattern pattern;
    private boolean fits;
    private int[] order = {};
    private int[] place = {};
    private int[] lowerStart = {};
    private int[] lowerColumn = {};
    private int[] upperStart = {};
    private int[] upperColumn = {};
    private double[] lower = {};
    private double[] upper = {};
    private double[] inverse = {};
    private double[] row = {};
    private double[] solution = {};
    private final double[] factor = new double[9];
    private long operations;

    BlockLU(ImplicitWork.Counter work) {
        this.work = work;
    }

    /** Whether the factors of this pattern have no more blocks than the given number; finds the order if it is new. */
    boolean fits(BlockPattern pattern, long mostBlocks) {
        if (this.pattern != pattern) {
            this.pattern = pattern;
            fits = analyse(mostBlocks);
        }
        return fits;
    }

    private boolean analyse(long mostBlocks) {
        int n = pattern.rows;
        order = new int[n];
        if (n > 0) {
            Damd_order.amd_order(n, pattern.rowStart, pattern.column, order, null, null);
        }
        place = new int[n];
        for (int k = 0; k < n; k++) {
            place[order[k]] = k;
        }
        int[] parent = eliminationTree(n);
        int[] mark = new int[n];
        int[] reach = new int[n];
        lowerStart = new int[n + 1];
        upperStart = new int[n + 1];
        Arrays.fill(mark, -1);
        long blocks = 0;
        for (int i = 0; i < n; i++) {
            int count = reach(i, parent, mark, reach);
            blocks += 2L * count;
            if (blocks > mostBlocks) {
                return false;
            }
            lowerStart[i + 1] = lowerStart[i] + count;
            for (int r = 0; r < count; r++) {
                upperStart[reach[r] + 1]++;
            }
        }
        for (int k = 0; k < n; k++) {
            upperStart[k + 1] += upperStart[k];
        }
        lowerColumn = new int[lowerStart[n]];
        upperColumn = new int[upperStart[n]];
        int[] filled = Arrays.copyOf(upperStart, n);
        Arrays.fill(mark, -1);
        operations = 0;
        for (int i = 0; i < n; i++) {
            int count = reach(i, parent, mark, reach);
            Arrays.sort(reach, 0, count);
            System.arraycopy(reach, 0, lowerColumn, lowerStart[i], count);
            for (int r = 0; r < count; r++) {
                upperColumn[filled[reach[r]]++] = i;
                operations += 1 + upperStart[reach[r] + 1] - upperStart[reach[r]];
            }
        }
        lower = new double[9 * lowerColumn.length];
        upper = new double[9 * upperColumn.length];
        inverse = new double[9 * n];
        row = new double[9 * n];
        solution = new double[3 * n];
        return true;
    }

    private int[] eliminationTree(int n) {
        int[] parent = new int[n];
        int[] ancestor = new int[n];
        for (int i = 0; i < n; i++) {
            parent[i] = -1;
            ancestor[i] = -1;
            int from = order[i];
            for (int s = pattern.rowStart[from]; s < pattern.rowStart[from + 1]; s++) {
                for (int k = place[pattern.column[s]]; k >= 0 && k < i;) {
                    int next = ancestor[k];
                    ancestor[k] = i;
                    if (next < 0) {
                        parent[k] = i;
                    }
                    k = next;
                }
            }
        }
        return parent;
    }

    /** The columns of L in row i: all that the row's entries reach in the elimination tree below i. */
    private int reach(int i, int[] parent, int[] mark, int[] reach) {
        int count = 0;
        mark[i] = i;
        int from = order[i];
        for (int s = pattern.rowStart[from]; s < pattern.rowStart[from + 1]; s++) {
            for (int k = place[pattern.column[s]]; k >= 0 && k < i && mark[k] != i; k = parent[k]) {
                mark[k] = i;
                reach[count++] = k;
            }
        }
        return count;
    }

    /** Factorises the matrix with these values in the pattern that {@link #fits}; false if a pivot block is singular. */
    boolean factorise(double[] a) {
        work.factorisations++;
        work.blockOperations += operations;
        for (int i = 0; i < pattern.rows; i++) {
            spread(a, i);
            for (int l = lowerStart[i]; l < lowerStart[i + 1]; l++) {
                int k = lowerColumn[l];
                Block3.multiply(row, 9 * k, inverse, 9 * k, factor, 0);
                System.arraycopy(factor, 0, lower, 9 * l, 9);
                subtractRow(k);
            }
            System.arraycopy(row, 9 * i, factor, 0, 9);
            if (!Block3.invert(factor, 0, inverse, 9 * i)) {
                return false;
            }
            for (int u = upperStart[i]; u < upperStart[i + 1]; u++) {
                System.arraycopy(row, 9 * upperColumn[u], upper, 9 * u, 9);
            }
        }
        return true;
    }

    /** Lays out row i of the reordered matrix, with zeros where it will fill in. */
    private void spread(double[] a, int i) {
        for (int l = lowerStart[i]; l < lowerStart[i + 1]; l++) {
            Arrays.fill(row, 9 * lowerColumn[l], 9 * lowerColumn[l] + 9, 0);
        }
        for (int u = upperStart[i]; u < upperStart[i + 1]; u++) {
            Arrays.fill(row, 9 * upperColumn[u], 9 * upperColumn[u] + 9, 0);
        }
        int from = order[i];
        for (int s = pattern.rowStart[from]; s < pattern.rowStart[from + 1]; s++) {
            System.arraycopy(a, 9 * s, row, 9 * place[pattern.column[s]], 9);
        }
    }

    /** row -= factor times row k of U. */
    private void subtractRow(int k) {
        double f0 = factor[0];
        double f1 = factor[1];
        double f2 = factor[2];
        double f3 = factor[3];
        double f4 = factor[4];
        double f5 = factor[5];
        double f6 = factor[6];
        double f7 = factor[7];
        double f8 = factor[8];
        for (int u = upperStart[k], at = 9 * u, end = upperStart[k + 1]; u < end; u++, at += 9) {
            int to = 9 * upperColumn[u];
            for (int c = 0; c < 3; c++) {
                double u0 = upper[at + c];
                double u1 = upper[at + c + 3];
                double u2 = upper[at + c + 6];
                row[to + c] -= f0 * u0 + f1 * u1 + f2 * u2;
                row[to + c + 3] -= f3 * u0 + f4 * u1 + f5 * u2;
                row[to + c + 6] -= f6 * u0 + f7 * u1 + f8 * u2;
            }
        }
    }

    /** y = U<sup>-1</sup> L<sup>-1</sup> x. */
    @Override
    public void apply(double[] x, double[] y) {
        int n = pattern.rows;
        work.blockOperations += blocks();
        for (int i = 0; i < n; i++) {
            System.arraycopy(x, 3 * order[i], solution, 3 * i, 3);
            for (int l = lowerStart[i]; l < lowerStart[i + 1]; l++) {
                Block3.multiplySubtract(lower, 9 * l, solution, 3 * lowerColumn[l], solution, 3 * i);
            }
        }
        for (int i = n - 1; i >= 0; i--) {
            for (int u = upperStart[i]; u < upperStart[i + 1]; u++) {
                Block3.multiplySubtract(upper, 9 * u, solution, 3 * upperColumn[u], solution, 3 * i);
            }
            int to = 3 * order[i];
            Arrays.fill(y, to, to + 3, 0);
            Block3.multiplyAdd(inverse, 9 * i, solution, 3 * i, y, to);
            System.arraycopy(y, to, solution, 3 * i, 3);
        }
    }

    /** Blocks of the factors: products of a block with three entries that {@link #apply} takes. */
    long blocks() {
        return (long) lowerColumn.length + upperColumn.length + pattern.rows;
    }

    /** What a factorisation takes, in such products. */
    long cost() {
        return 3 * operations;
    }
}
