package deSolvers.extrapolation;

/**
 * Extrapolation table (Aitken-Neville scheme): extrapolates results whose error has only even powers of the substep to
 * substeps of length 0. Only the last line is kept:
 * <pre>
 *   T_00
 *   T_10  T_11              T_jk = T_j,k-1 + (T_j,k-1 - T_j-1,k-1) / ((n_j / n_j-k)^2 - 1)
 *   T_20  T_21  T_22
 * </pre>
 */
final class ExtrapolationTable {
    // from right to left: T_jk in line[j - k]
    private final double[][] line = new double[OrderControl.COLUMNS][0];
    private double[] correction = {};

    void resize(int n) {
        for (int j = 0; j < line.length; j++) {
            line[j] = new double[n];
        }
        correction = new double[n];
    }

    /** @return the array into which T_j0 is to be written before {@link #extrapolate} */
    double[] begin(int j) {
        return line[j];
    }

    /** Computes line j from line j - 1 and T_j0. */
    void extrapolate(int j) {
        for (int k = 1; k <= j; k++) {
            double n = (double) OrderControl.substeps(j) / OrderControl.substeps(j - k);
            double divisor = n * n - 1;
            double[] finer = line[j - k + 1];
            double[] coarser = line[j - k];
            for (int i = 0; i < correction.length; i++) {
                correction[i] = (finer[i] - coarser[i]) / divisor;
                coarser[i] = finer[i] + correction[i];
            }
        }
    }

    /** @return T_jj */
    double[] result() {
        return line[0];
    }

    /** @return T_jj - T_j,j-1 */
    double[] getCorrection() {
        return correction;
    }
}
