package deSolvers.linear;

import java.util.Arrays;

/**
 * A square matrix A and its factors L U in an envelope: row r and column r are stored from the same first entry to the
 * diagonal, and the factors have no entries outside (A. Jennings 1966; also called skyline or profile). The matrix of a
 * chain has a few entries per row, so the time is proportional to the chain's length. There is no pivoting: the matrix
 * of constraint forces, J W J<sup>T</sup>, does not need it, and friction makes it only a little unsymmetric; callers
 * check the residual.
 */
public final class EnvelopeMatrix {
    private int size;
    private int[] first = new int[4];                   // column of a row's first entry
    private int[] begin = new int[4];                   // index where column 0 of a row would be
    private double[] lower = new double[16];            // A by rows, with the diagonal
    private double[] upper = new double[16];            // A by columns, without it
    private double[] l = new double[16];
    private double[] u = new double[16];                // its diagonal is 1
    private boolean[] factored = new boolean[4];        // the rows in the factors
    private boolean current;                            // whether the factors are those of A

    /** Starts a matrix without rows. */
    public void clear() {
        size = 0;
        current = false;
    }

    /**
     * Adds a row and a column of zeros.
     *
     * @param first the first entry that can differ from zero
     */
    public void add(int first) {
        int place = size == 0 ? 0 : begin[size - 1] + size;
        int after = place + size - first + 1;
        if (size == this.first.length) {
            this.first = Arrays.copyOf(this.first, 2 * size);
            begin = Arrays.copyOf(begin, 2 * size);
            factored = new boolean[2 * size];
        }
        if (after > lower.length) {
            lower = Arrays.copyOf(lower, 2 * after);
            upper = Arrays.copyOf(upper, 2 * after);
            l = new double[2 * after];
            u = new double[2 * after];
        }
        this.first[size] = first;
        begin[size++] = place - first;
    }

    /**
     * Sets A(row, column) and A(column, row).
     *
     * @param column in the envelope, not to the right of the diagonal
     * @param below  A(row, column)
     * @param above  A(column, row); not used on the diagonal
     */
    public void set(int row, int column, double below, double above) {
        lower[begin[row] + column] = below;
        upper[begin[row] + column] = above;
        current = false;
    }

    /** @return the number of rows */
    public int size() {
        return size;
    }

    /** @return the first column of a row's envelope */
    public int first(int row) {
        return first[row];
    }

    /** @return an entry of A */
    public double get(int row, int column) {
        int r = Math.max(row, column);
        int c = Math.min(row, column);
        return c < first[r] ? 0 : (row < column ? upper : lower)[begin[r] + c];
    }

    /**
     * Factorises the part of A whose rows and columns are active, if that has not been done already.
     *
     * @param smallest the smallest pivot allowed, as a fraction of its diagonal entry
     * @return false if a pivot is smaller: the row is nearly a linear combination of earlier ones; the factors are then
     *         invalid
     */
    public boolean factorise(boolean[] active, double smallest) {
        for (int r = 0; r < size; r++) {
            current &= active[r] == factored[r];
        }
        if (current) {
            return true;
        }
        for (int r = 0; r < size; r++) {
            int row = begin[r];
            double pivot = active[r] ? lower[row + r] : 1;
            double least = smallest * pivot;
            for (int c = first[r]; c < r; c++) {
                boolean both = active[r] && active[c];
                double below = both ? lower[row + c] : 0;
                double above = both ? upper[row + c] : 0;
                for (int k = Math.max(first[r], first[c]), column = begin[c]; both && k < c; k++) {
                    below -= l[row + k] * u[column + k];
                    above -= l[column + k] * u[row + k];
                }
                l[row + c] = below;
                u[row + c] = above / l[begin[c] + c];
                pivot -= l[row + c] * u[row + c];
            }
            if (!(pivot > least)) {
                return false;
            }
            l[row + r] = pivot;
        }
        System.arraycopy(active, 0, factored, 0, size);
        current = true;
        return true;
    }

    /**
     * Solves L U x = b.
     *
     * @param x holds b, 0 where a row is not active; receives x
     */
    public void solve(double[] x) {
        for (int r = 0; r < size; r++) {
            double sum = x[r];
            for (int c = first[r]; c < r; c++) {
                sum -= l[begin[r] + c] * x[c];
            }
            x[r] = sum / l[begin[r] + r];
        }
        for (int r = size - 1; r > 0; r--) {
            for (int c = first[r]; c < r; c++) {
                x[c] -= u[begin[r] + c] * x[r];
            }
        }
    }

    /** Computes y = A x - b. */
    public void residual(double[] x, double[] b, double[] y) {
        for (int r = 0; r < size; r++) {
            double sum = lower[begin[r] + r] * x[r] - b[r];
            for (int c = first[r]; c < r; c++) {
                sum += lower[begin[r] + c] * x[c];
                y[c] += upper[begin[r] + c] * x[r];
            }
            y[r] = sum;
        }
    }
}
