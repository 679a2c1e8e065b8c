package particles.reactions.algebra;

import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.MatrixFeatures_DDRM;
import org.ejml.dense.row.decomposition.qr.QRColPivDecompositionHouseholderColumn_DDRM;
import org.ejml.dense.row.linsol.qr.SolvePseudoInverseQrp_DDRM;

/** Minimum-norm least-squares solution of a square system of any rank, by QR decomposition with column pivoting. */
public final class MinimumNormSolution {
    /** Entries below this, relative to the largest of R, are round-off. */
    private static final double SINGULAR = 1e-11;

    private QRColPivDecompositionHouseholderColumn_DDRM decomposition;
    private SolvePseudoInverseQrp_DDRM solver;
    private final DMatrixRMaj matrix = new DMatrixRMaj(0, 0);
    private final DMatrixRMaj decomposed = new DMatrixRMaj(0, 0);
    private final DMatrixRMaj right = new DMatrixRMaj(0, 1);
    private final DMatrixRMaj result = new DMatrixRMaj(0, 1);

    /** Creates a solver without a matrix. */
    public MinimumNormSolution() {
        renew();
    }

    private void renew() {
        decomposition = new QRColPivDecompositionHouseholderColumn_DDRM(SINGULAR);
        solver = new SolvePseudoInverseQrp_DDRM(decomposition, true);
    }

    /** Starts a matrix of zeros. */
    public void begin(int n) {
        if (n != matrix.numRows) {                      // the library's decomposition does not shrink with its matrix
            renew();
        }
        matrix.reshape(n, n);
        matrix.zero();
        right.reshape(n, 1);
        result.reshape(n, 1);
    }

    /** Sets an entry of the matrix. */
    public void set(int row, int column, double value) {
        matrix.set(row, column, value);
    }

    /** Factorises the matrix, which may be overwritten. */
    public void factorise() {
        if (MatrixFeatures_DDRM.isZeros(matrix, 0)) {   // the library keeps the rank of the matrix before
            renew();
        }
        decomposed.setTo(matrix);
        solver.setA(decomposed);
    }

    /** @param x holds b, receives x; the first n entries */
    public void solve(double[] x) {
        System.arraycopy(x, 0, right.data, 0, matrix.numRows);
        solver.solve(right, result);
        System.arraycopy(result.data, 0, x, 0, matrix.numRows);
    }
}
