package deSolvers.extrapolation;

import java.util.Arrays;

/**
 * The Taylor coefficients of the solution at the middle of a stretch, from what the modified midpoint method met on its
 * way: the states there, and central differences of the derivatives around it. Both have errors in even powers of the
 * substep and are extrapolated like the result itself.
 */
final class MiddleDerivatives {
    private final Column[] columns = new Column[OrderControl.COLUMNS];
    private final double[] table = new double[OrderControl.COLUMNS];
    private int n;

    /** What one column met. */
    private static final class Column implements ModifiedMidpoint.Record {
        private final double[][] slopes;
        private final double[] middle;

        Column(int substeps, int n) {
            slopes = new double[substeps + 1][n];
            middle = new double[n];
        }

        @Override
        public void middle(double[] state) {
            System.arraycopy(state, 0, middle, 0, state.length);
        }

        @Override
        public void slope(int i, double[] dSdt) {
            System.arraycopy(dSdt, 0, slopes[i], 0, dSdt.length);
        }
    }

    void resize(int n) {
        this.n = n;
        Arrays.fill(columns, null);
    }

    /** @return where the column's coverage is to be recorded */
    ModifiedMidpoint.Record record(int column) {
        if (columns[column] == null) {
            columns[column] = new Column(OrderControl.substeps(column), n);
        }
        return columns[column];
    }

    /**
     * @param last   the last column covered
     * @param h      the stretch (s)
     * @param degree the highest coefficient wanted, up to 2 last + 2
     * @param c      receives h<sup>k</sup>/k! times the k-th derivative in c[k], k = 0 ... degree
     */
    void taylor(int last, double h, int degree, double[][] c) {
        for (int i = 0; i < n; i++) {
            double factorial = 1;
            for (int k = 0; k <= degree; k++) {
                int first = (k + 1) / 2 - (k == 0 ? 0 : 1);     // column j has differences up to order 2 j + 1
                for (int j = first; j <= last; j++) {
                    table[j] = k == 0 ? columns[j].middle[i] : difference(columns[j].slopes, i, k - 1, h);
                }
                c[k][i] = extrapolated(first, last) / factorial;
                factorial *= k + 1;
            }
        }
    }

    /**
     * h<sup>m+1</sup> times the m-th derivative of f at the middle, by m central differences over two substeps each. These
     * are parts of h, so that no power of h is needed, which may overflow or vanish.
     */
    private static double difference(double[][] slopes, int i, int m, double h) {
        int substeps = slopes.length - 1;
        int middle = substeps / 2;
        double sum = 0;
        double binomial = 1;
        for (int q = 0; q <= m; q++) {
            sum += (q % 2 == 0 ? binomial : -binomial) * slopes[middle + m - 2 * q][i];
            binomial = binomial * (m - q) / (q + 1);
        }
        sum *= h;
        double twoSubsteps = 2.0 / substeps;        // in h
        for (int q = 0; q < m; q++) {
            sum /= twoSubsteps;
        }
        return sum;
    }

    private double extrapolated(int first, int last) {
        for (int k = 1; k <= last - first; k++) {
            for (int j = last; j >= first + k; j--) {
                double ratio = (double) OrderControl.substeps(j) / OrderControl.substeps(j - k);
                table[j] += (table[j] - table[j - 1]) / (ratio * ratio - 1);
            }
        }
        return table[last];
    }
}
