package deSolvers.linear;

/**
 * The rows of the pivot block that a {@link Front} eliminates, or of two blocks one after the other: their multiples
 * are added to the rows below in one pass, since a pass over a large front takes longer than the arithmetic of one
 * block. The loops are such as the compiler makes vector instructions of: along one row, with an array for each row of
 * the blocks.
 */
final class PivotRows {
    private final double[][] front;
    private final double[][] factors;                   // of each row below, what each of the blocks' is multiplied by
    private int k;                                      // the first row of the first block

    /** @param front the rows, those of the blocks and those below */
    PivotRows(double[][] front) {
        this.front = front;
        factors = new double[6][front.length];
    }

    /**
     * Takes up the pivot block at row k.
     *
     * @param second    whether it is the second one of two
     * @param columns   of three its columns, each as a row, from entry k + 3 on
     * @param at        the first of the three
     * @param rows      where the columns end
     * @param inverse   of the block
     * @param inverseAt where that begins
     */
    void take(int k, boolean second, double[][] columns, int at, int rows, double[] inverse, int inverseAt) {
        this.k = second ? k - 3 : k;
        for (int c = 0; c < 3; c++) {
            int i = inverseAt + c;
            double[] f = factors[second ? c + 3 : c];
            multiply(columns, at, -inverse[i], -inverse[i + 3], -inverse[i + 6], f, k + 3, rows);
        }
    }

    private static void multiply(double[][] columns, int at, double m0, double m1, double m2, double[] f, int from,
            int to) {
        double[] a0 = columns[at];
        double[] a1 = columns[at + 1];
        double[] a2 = columns[at + 2];
        for (int r = from; r < to; r++) {
            f[r] = a0[r] * m0 + a1[r] * m1 + a2[r] * m2;
        }
    }

    /** Adds the first block's rows, each multiplied, to row r in a range of columns. */
    void addFirst(int r, int from, int to) {
        double[] a = front[r];
        double[] u0 = front[k];
        double[] u1 = front[k + 1];
        double[] u2 = front[k + 2];
        double f0 = factors[0][r];
        double f1 = factors[1][r];
        double f2 = factors[2][r];
        for (int j = from; j < to; j++) {
            a[j] = Math.fma(f0, u0[j], Math.fma(f1, u1[j], Math.fma(f2, u2[j], a[j])));
        }
    }

    /** Adds the rows of both blocks, each multiplied, to row r in a range of columns. */
    void addBoth(int r, int from, int to) {
        double[] a = front[r];
        double[] u0 = front[k];
        double[] u1 = front[k + 1];
        double[] u2 = front[k + 2];
        double[] v0 = front[k + 3];
        double[] v1 = front[k + 4];
        double[] v2 = front[k + 5];
        double f0 = factors[0][r];
        double f1 = factors[1][r];
        double f2 = factors[2][r];
        double g0 = factors[3][r];
        double g1 = factors[4][r];
        double g2 = factors[5][r];
        for (int j = from; j < to; j++) {
            a[j] = Math.fma(g0, v0[j], Math.fma(g1, v1[j], Math.fma(g2, v2[j],
                    Math.fma(f0, u0[j], Math.fma(f1, u1[j], Math.fma(f2, u2[j], a[j]))))));
        }
    }
}
