package particles.teaching.solvers;

import java.util.Arrays;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/** The weights with which some columns add up to another one as nearly as possible, by EJML. */
final class LeastSquares {
    private LeastSquares() {
    }

    /** @return the weights; NaN where the columns depend on each other */
    static double[] weights(double[][] columns, double[] expected) {
        DMatrixRMaj matrix = new DMatrixRMaj(columns);
        CommonOps_DDRM.transpose(matrix);
        DMatrixRMaj weights = new DMatrixRMaj(columns.length, 1);
        if (!CommonOps_DDRM.solve(matrix, new DMatrixRMaj(expected), weights)) {
            Arrays.fill(weights.data, Double.NaN);
        }
        return weights.data;
    }
}
