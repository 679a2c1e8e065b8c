package deSolvers.linear;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.MatrixFeatures_DDRM;
import org.ejml.dense.row.decomposition.qr.QRColPivDecompositionHouseholderColumn_DDRM;
import org.ejml.dense.row.linsol.qr.SolvePseudoInverseQrp_DDRM;

/** Minimum-norm least-squares solution of a square system of any rank, by QR decomposition with column pivoting. */
public final class MinimumNormSolution {
    private QRColPivDecompositionHouseholderColumn_DDRM decomposition;
    private SolvePseudoInverseQrp_DDRM solver;
    private final DMatrixRMaj matrix = new DMatrixRMaj(0, 0);
    private final DMatrixRMaj right = new DMatrixRMaj(0, 1);
    private final DMatrixRMaj result = new DMatrixRMaj(0, 1);

    private void renew() {
        decomposition = new QRColPivDecompositionHouseholderColumn_DDRM();
        solver = new SolvePseudoInverseQrp_DDRM(decomposition, true);
    }

    /**
     * Solves A x = b in the active rows and columns.
     *
     * @param x        receives the solution, 0 where a row is not active
     * @param singular entries of R below this fraction of the largest are round-off
     */
    public void solve(EnvelopeMatrix a, boolean[] active, double[] b, double[] x, double singular) {
        int[] rows = IntStream.range(0, a.size()).filter(r -> active[r]).toArray();
        int n = rows.length;
        boolean resized = n != matrix.numRows;      // the library's decomposition does not shrink with its matrix
        matrix.reshape(n, n);
        right.reshape(n, 1);
        result.reshape(n, 1);
        for (int r = 0; r < n; r++) {
            right.set(r, 0, b[rows[r]]);
            for (int c = 0; c < n; c++) {
                matrix.set(r, c, a.get(rows[r], rows[c]));
            }
        }
        if (resized || MatrixFeatures_DDRM.isZeros(matrix, 0)) {    // and it keeps the rank of the matrix before
            renew();
        }
        decomposition.setSingularThreshold(singular);
        solver.setA(matrix);
        solver.solve(right, result);
        Arrays.fill(x, 0, a.size(), 0.0);
        for (int r = 0; r < n; r++) {
            x[rows[r]] = result.get(r);
        }
    }
}
