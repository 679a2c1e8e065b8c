package particles.reactions.algebra;

import java.util.Arrays;

/**
 * Cholesky factorisation A = L L<sup>T</sup> of a symmetric positive definite matrix with an envelope: each row is
 * stored from its first nonzero entry to the diagonal, and L needs no more. (Method: A. Jennings 1966; the same as a
 * skyline or profile solver.)
 */
public final class EnvelopeCholesky {
    private final int size;
    private final int[] first;                          // column of a row's first entry
    private final int[] begin;                          // index where column 0 of a row would be
    private final double[] entries;
    private final double[] pivots;

    /** @param first for each row, the column of its first entry that can differ from zero; at most the row itself */
    public EnvelopeCholesky(int[] first) {
        size = first.length;
        this.first = first.clone();
        begin = new int[size];
        int place = 0;
        for (int r = 0; r < size; r++) {
            begin[r] = place - first[r];
            place += r - first[r] + 1;
        }
        entries = new double[place];
        pivots = new double[size];
    }

    /** Sets all entries to 0. */
    public void clear() {
        Arrays.fill(entries, 0);
    }

    /** Adds to the entry of a row and a column that is not to its right. */
    public void add(int row, int column, double amount) {
        entries[begin[row] + column] += amount;
    }

    /** An entry on or left of the diagonal: of A before {@link #factorise}, of L after it. */
    public double get(int row, int column) {
        return column < first[row] ? 0 : entries[begin[row] + column];
    }

    /**
     * Replaces A by L.
     *
     * @param smallest the smallest pivot allowed, as a fraction of its diagonal entry
     * @return false if a pivot is smaller: the row is nearly a linear combination of earlier ones; entries are then
     *         invalid
     */
    public boolean factorise(double smallest) {
        for (int r = 0; r < size; r++) {
            double diagonal = entries[begin[r] + r];
            double left = diagonal;
            for (int c = first[r]; c < r; c++) {
                double sum = entries[begin[r] + c];
                for (int k = Math.max(first[r], first[c]); k < c; k++) {
                    sum -= entries[begin[r] + k] * entries[begin[c] + k];
                }
                sum /= pivots[c];
                entries[begin[r] + c] = sum;
                left -= sum * sum;
            }
            if (!(left > smallest * diagonal)) {
                return false;
            }
            pivots[r] = Math.sqrt(left);
            entries[begin[r] + r] = pivots[r];
        }
        return true;
    }

    /** Solves L L<sup>T</sup> x = b. @param x holds b, receives x */
    public void solve(double[] x) {
        for (int r = 0; r < size; r++) {
            double sum = x[r];
            for (int c = first[r]; c < r; c++) {
                sum -= entries[begin[r] + c] * x[c];
            }
            x[r] = sum / pivots[r];
        }
        for (int r = size - 1; r >= 0; r--) {
            x[r] /= pivots[r];
            for (int c = first[r]; c < r; c++) {
                x[c] -= entries[begin[r] + c] * x[r];
            }
        }
    }
}
