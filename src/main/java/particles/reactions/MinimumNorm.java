package particles.reactions;

import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.decomposition.qr.QRColPivDecompositionHouseholderColumn_DDRM;
import org.ejml.dense.row.linsol.qr.SolvePseudoInverseQrp_DDRM;

/**
 * A square system of any rank, by QR decomposition with column pivoting: of all x with the least |A x - b| it finds the
 * smallest.
 */
final class MinimumNorm {
    /** Relative to the largest entry of R; less is rounding. */
    private static final double SINGULAR = 1e-11;

    private final SolvePseudoInverseQrp_DDRM solver =
            new SolvePseudoInverseQrp_DDRM(new QRColPivDecompositionHouseholderColumn_DDRM(SINGULAR), true);
    private final DMatrixRMaj matrix = new DMatrixRMaj(0, 0);
    private final DMatrixRMaj decomposed = new DMatrixRMaj(0, 0);
    private final DMatrixRMaj right = new DMatrixRMaj(0, 1);
    private final DMatrixRMaj result = new DMatrixRMaj(0, 1);

    /** Starts a matrix of zeros. */
    void begin(int n) {
        matrix.reshape(n, n);
        matrix.zero();
        right.reshape(n, 1);
        result.reshape(n, 1);
    }

    void set(int row, int column, double value) {
        matrix.set(row, column, value);
    }

    double get(int row, int column) {
        return matrix.get(row, column);
    }

    /** The decomposition may overwrite what it is given. */
    void factorise() {
        decomposed.setTo(matrix);
        solver.setA(decomposed);
    }

    /**
     * @param x holds b, receives x; the first n entries
     * @return the largest entry of |A x - b|, relative to the largest of |b|; 0 for b = 0
     */
    double solve(double[] x) {
        int n = matrix.numRows;
        System.arraycopy(x, 0, right.data, 0, n);
        solver.solve(right, result);
        double largest = 0;
        double left = 0;
        for (int r = 0; r < n; r++) {
            double sum = -right.data[r];
            for (int c = 0; c < n; c++) {
                sum += matrix.get(r, c) * result.data[c];
            }
            left = Math.max(left, Math.abs(sum));
            largest = Math.max(largest, Math.abs(right.data[r]));
        }
        System.arraycopy(result.data, 0, x, 0, n);
        return largest == 0 ? 0 : left / largest;
    }
}
