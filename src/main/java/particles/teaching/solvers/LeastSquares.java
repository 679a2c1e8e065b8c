package particles.teaching.solvers;

import java.util.Arrays;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import particles.teaching.contract.SolverContract;

/** The weights with which some columns add up to others as nearly as possible, by EJML. */
final class LeastSquares {
    private LeastSquares() {
    }

    /** @return the weights for each of the sums; NaN where the columns depend on each other */
    static double[][] weights(double[][] columns, double[]... sums) {
        DMatrixRMaj matrix = new DMatrixRMaj(columns);
        CommonOps_DDRM.transpose(matrix);
        DMatrixRMaj expected = new DMatrixRMaj(sums);
        CommonOps_DDRM.transpose(expected);
        DMatrixRMaj weights = new DMatrixRMaj(columns.length, sums.length);
        if (!CommonOps_DDRM.solve(matrix, expected, weights)) {
            Arrays.fill(weights.data, Double.NaN);
        }
        double[][] all = new double[sums.length][columns.length];
        Arrays.setAll(all, i -> CommonOps_DDRM.extractColumn(weights, i, null).data);
        return all;
    }

    /** @return the largest difference between the sum of the columns with these weights and another column */
    static double misfit(double[][] columns, double[] weights, double[] expected) {
        double[] sum = new double[expected.length];
        for (int j = 0; j < columns.length; j++) {
            sum = Combination.plus(sum, weights[j], columns[j]);
        }
        return SolverContract.distance(sum, expected);
    }
}
