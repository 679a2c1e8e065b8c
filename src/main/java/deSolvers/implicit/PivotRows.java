package deSolvers.implicit;

/**
 * The rows of the pivot block that a {@link Front} eliminates, or of two blocks one after the other: their multiples are added
 * to the rows below in one pass, since a pass over a large front takes longer than the arithmetic of one block. The loops are
 * such as the compiler makes vector instructions of; of one that goes over three rows at once it does not.
 */
final class PivotRows {
    private final double[][] row;

    /** @param width entries of the longest row */
    PivotRows(int width) {
        row = new double[6][width];
    }

    /** A row: 0 to 2 of the first block, 3 to 5 of the second. */
    double[] get(int r) {
        return row[r];
    }

    /** a += f U in a range of columns: U is the rows of the first block, f three numbers. */
    void add(double[] a, double[] f, int at, int from, int to) {
        double[] u0 = row[0];
        double[] u1 = row[1];
        double[] u2 = row[2];
        double f0 = f[at];
        double f1 = f[at + 1];
        double f2 = f[at + 2];
        for (int j = from; j < to; j++) {
            a[j] = Math.fma(f0, u0[j], Math.fma(f1, u1[j], Math.fma(f2, u2[j], a[j])));
        }
    }

    /** a += f U + g V in a range of columns: V is the rows of the second block. */
    void add(double[] a, double[] f, int at, double[] g, int gAt, int from, int to) {
        double[] u0 = row[0];
        double[] u1 = row[1];
        double[] u2 = row[2];
        double[] v0 = row[3];
        double[] v1 = row[4];
        double[] v2 = row[5];
        double f0 = f[at];
        double f1 = f[at + 1];
        double f2 = f[at + 2];
        double g0 = g[gAt];
        double g1 = g[gAt + 1];
        double g2 = g[gAt + 2];
        for (int j = from; j < to; j++) {
            a[j] = Math.fma(g0, v0[j], Math.fma(g1, v1[j], Math.fma(g2, v2[j],
                    Math.fma(f0, u0[j], Math.fma(f1, u1[j], Math.fma(f2, u2[j], a[j]))))));
        }
    }
}
