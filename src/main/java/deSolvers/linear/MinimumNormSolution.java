package deSolvers.linear;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.decomposition.qr.QRColPivDecompositionHouseholderColumn_DDRM;
import org.ejml.dense.row.linsol.qr.SolvePseudoInverseQrp_DDRM;

/** Minimum-norm least-squares solution of a square system of any rank, by QR decomposition with column pivoting. */
public final class MinimumNormSolution {
    private MinimumNormSolution() {
    }

    /**
     * Solves A x = b in the active rows and columns.
     *
     * @param x        receives the solution, 0 where a row is not active
     * @param singular entries of R below this fraction of the largest are round-off
     */
    public static void solve(EnvelopeMatrix a, boolean[] active, double[] b, double[] x, double singular) {
        int[] rows = IntStream.range(0, a.size()).filter(r -> active[r]).toArray();
        int n = rows.length;
        DMatrixRMaj matrix = new DMatrixRMaj(n, n);
        DMatrixRMaj right = new DMatrixRMaj(n, 1);
        DMatrixRMaj result = new DMatrixRMaj(n, 1);
        for (int r = 0; r < n; r++) {
            right.set(r, 0, b[rows[r]]);
            for (int c = 0; c < n; c++) {
                matrix.set(r, c, a.get(rows[r], rows[c]));
            }
        }
        // new for each matrix: the library's decomposition keeps the size and the rank of the one before
        QRColPivDecompositionHouseholderColumn_DDRM decomposition = new QRColPivDecompositionHouseholderColumn_DDRM();
        decomposition.setSingularThreshold(singular);
        SolvePseudoInverseQrp_DDRM solver = new SolvePseudoInverseQrp_DDRM(decomposition, true);
        solver.setA(matrix);
        solver.solve(right, result);
        Arrays.fill(x, 0, a.size(), 0.0);
        for (int r = 0; r < n; r++) {
            x[rows[r]] = result.get(r);
        }
    }
}
