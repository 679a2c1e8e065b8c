package deSolvers.linear;

import java.util.Arrays;

/**
 * A sparse factorisation A = L D U of a {@link BlockMatrix}; of a symmetric matrix U = L<sup>T</sup>, at half the work.
 *
 * <p>Rows are eliminated in the order that {@link NestedDissection} finds. Eliminating row k adds entries, the fill-in,
 * at (i, j) wherever (i, k) and (k, j) are entries. The symbolic phase finds them all: column k of L has the entries of
 * A and those of its children in the elimination tree, where the parent of a column is the row of its first entry below
 * the diagonal. The numerical phase is left-looking: column c is that of A, minus the contributions of all earlier
 * columns with an entry in row c. There is no pivoting outside the diagonal blocks. {@link Gmres} makes up for the
 * accuracy that this costs.
 *
 * <p>Source: A. George, J. W. H. Liu, <i>Computer Solution of Large Sparse Positive Definite Systems</i>, Prentice-Hall
 * 1981, chapter 5; T. A. Davis, <i>Direct Methods for Sparse Linear Systems</i>, SIAM 2006, chapter 4, for the
 * elimination tree.
 */
final class BlockFactors implements LinearOperator {
    /** Factors of more blocks than this, of 72 bytes each, are not made. */
    private static final int MOST_BLOCKS = 2_000_000;
    private static final int NONE = -1;

    private final SolverWork work;
    private final BlockPattern pattern;
    private final int[] order;                          // the rows in the order of elimination
    private final int[] place;                          // of each row in it
    private final int[] start;                          // of each column of L: where its entries begin
    private int[] row = {};                             // of each entry below the diagonal: its place; ascending
    private final boolean fits;
    private long products;                              // of two blocks, in a symmetric factorisation
    private boolean symmetric;
    private double[] lower = {};                        // L D by columns
    private double[] upper = {};                        // (D U) by rows, blocks transposed; the same array if symmetric
    private double[] inverse = {};                      // of the diagonal blocks D
    private final int[] at;                             // of each row: where its entry is in the present column
    private final int[] next;                           // of each column: its first entry that has not been used
    private final int[] first;                          // of each row: the columns whose next entry is there, as a list
    private final int[] link;
    private final double[] diagonal = new double[9];
    private final double[] factor = new double[9];
    private final double[] part = new double[3];
    private double[] solution = {};

    BlockFactors(BlockPattern pattern, SolverWork work) {
        this.pattern = pattern;
        this.work = work;
        int n = pattern.rows;
        order = NestedDissection.order(pattern);
        place = new int[n];
        for (int k = 0; k < n; k++) {
            place[order[k]] = k;
        }
        start = new int[n + 1];
        at = new int[n];
        next = new int[n];
        first = new int[n];
        link = new int[n];
        fits = findFill();
    }

    /** The symbolic phase; false if there would be too many entries. */
    private boolean findFill() {
        int n = order.length;
        int[] seen = new int[n];
        Arrays.fill(seen, NONE);
        Arrays.fill(first, NONE);
        for (int k = 0; k < n; k++) {
            int end = start[k];
            if (end > MOST_BLOCKS) {
                return false;
            }
            row = end + n > row.length ? Arrays.copyOf(row, 2 * (end + n)) : row;
            seen[k] = k;
            for (int s = pattern.rowStart[order[k]]; s < pattern.rowStart[order[k] + 1]; s++) {
                end = see(place[pattern.column[s]], k, seen, end);
            }
            for (int child = first[k]; child != NONE; child = link[child]) {
                for (int e = start[child]; e < start[child + 1]; e++) {
                    end = see(row[e], k, seen, end);
                }
            }
            Arrays.sort(row, start[k], end);
            start[k + 1] = end;
            if (end > start[k]) {
                int parent = row[start[k]];
                link[k] = first[parent];
                first[parent] = k;
            }
            long below = end - start[k];
            products += below * (below + 3) / 2;
        }
        return true;
    }

    private int see(int i, int k, int[] seen, int end) {
        if (i < k || seen[i] == k) {
            return end;
        }
        seen[i] = k;
        row[end] = i;
        return end + 1;
    }

    /** Whether there is room for the factors. */
    boolean isFit() {
        return fits;
    }

    /** The blocks that one {@link #apply} multiplies by. */
    long blocks() {
        return 2L * start[order.length] + order.length;
    }

    /** The products of blocks in a factorisation. */
    long products(boolean symmetric) {
        return symmetric ? products : 2 * products;
    }

    /**
     * The numerical phase.
     *
     * @param matrix    a matrix with the pattern of these factors
     * @param symmetric whether it is its own transpose
     * @return false if a diagonal block is singular
     */
    boolean factorise(BlockMatrix matrix, boolean symmetric) {
        int n = order.length;
        int entries = 9 * start[n];
        this.symmetric = symmetric;
        lower = lower.length == entries ? lower : new double[entries];
        Arrays.fill(lower, 0);
        upper = symmetric ? lower : upper.length == entries && upper != lower ? upper : new double[entries];
        Arrays.fill(upper, symmetric ? entries : 0, entries, 0);
        inverse = inverse.length == 9 * n ? inverse : new double[9 * n];
        work.factorisations++;
        work.blockOperations += products(symmetric);
        Arrays.fill(first, NONE);
        for (int c = 0; c < n; c++) {
            for (int e = start[c]; e < start[c + 1]; e++) {
                at[row[e]] = 9 * e;
            }
            scatter(matrix, c);
            for (int k = first[c], following; k != NONE; k = following) {
                following = link[k];
                int e = next[k]++;
                Arrays.fill(factor, 0);
                Block3.addBlockProduct(1, inverse, 9 * k, upper, 9 * e, true, factor, 0);
                Block3.addBlockProduct(-1, lower, 9 * e, factor, 0, false, diagonal, 0);
                for (int r = e + 1; r < start[k + 1]; r++) {
                    Block3.addBlockProduct(-1, lower, 9 * r, factor, 0, false, lower, at[row[r]]);
                }
                if (!symmetric) {
                    Arrays.fill(factor, 0);
                    Block3.addBlockProduct(1, lower, 9 * e, inverse, 9 * k, false, factor, 0);
                    for (int r = e + 1; r < start[k + 1]; r++) {
                        Block3.addBlockProduct(-1, upper, 9 * r, factor, 0, true, upper, at[row[r]]);
                    }
                }
                enter(k);
            }
            if (!Block3.invert(diagonal, 0, inverse, 9 * c)) {
                return false;
            }
            next[c] = start[c];
            enter(c);
        }
        return true;
    }

    /** Puts a column into the list of the row of its next entry. */
    private void enter(int k) {
        if (next[k] < start[k + 1]) {
            int i = row[next[k]];
            link[k] = first[i];
            first[i] = k;
        }
    }

    /** Copies column and row c of the matrix to where they stand in the factors. */
    private void scatter(BlockMatrix matrix, int c) {
        int i = order[c];
        System.arraycopy(matrix.getValues(), 9 * pattern.diagonal[i], diagonal, 0, 9);
        for (int s = pattern.rowStart[i]; s < pattern.rowStart[i + 1]; s++) {
            int j = pattern.column[s];
            if (place[j] > c) {
                for (int e = 0; e < 9; e++) {
                    upper[at[place[j]] + e % 3 * 3 + e / 3] = matrix.getValues()[9 * s + e];
                }
                if (!symmetric) {
                    System.arraycopy(matrix.getValues(), 9 * pattern.find(j, i), lower, at[place[j]], 9);
                }
            }
        }
    }

    /** y = A<sup>-1</sup> x, as far as the factors are exact. */
    @Override
    public void apply(double[] x, double[] y) {
        int n = order.length;
        work.blockOperations += blocks();
        solution = solution.length == x.length ? solution : new double[x.length];
        for (int k = 0; k < n; k++) {
            System.arraycopy(x, 3 * order[k], solution, 3 * k, 3);
        }
        for (int k = 0; k < n; k++) {                   // L D z = x, and z = D^-1 of that
            Arrays.fill(part, 0);
            Block3.addProduct(1, inverse, 9 * k, false, solution, 3 * k, part, 0);
            System.arraycopy(part, 0, solution, 3 * k, 3);
            for (int e = start[k]; e < start[k + 1]; e++) {
                Block3.addProduct(-1, lower, 9 * e, false, part, 0, solution, 3 * row[e]);
            }
        }
        for (int k = n - 1; k >= 0; k--) {              // U y = z
            Arrays.fill(part, 0);
            for (int e = start[k]; e < start[k + 1]; e++) {
                Block3.addProduct(1, upper, 9 * e, true, solution, 3 * row[e], part, 0);
            }
            Block3.addProduct(-1, inverse, 9 * k, false, part, 0, solution, 3 * k);
        }
        for (int k = 0; k < n; k++) {
            System.arraycopy(solution, 3 * k, y, 3 * order[k], 3);
        }
    }
}
