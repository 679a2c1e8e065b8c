package particles.teaching.solvers;

import java.util.Arrays;
import java.util.stream.IntStream;

/** The weights with which some columns add up to another one as nearly as possible. */
final class LeastSquares {
    private LeastSquares() {
    }

    /** By orthogonal columns (modified Gram-Schmidt), which keep the digits that normal equations lose. */
    static double[] weights(double[][] columns, double[] expected) {
        int n = columns.length;
        double[][] q = new double[n][];
        double[][] r = new double[n][n];
        double[] right = new double[n];
        for (int j = 0; j < n; j++) {
            q[j] = columns[j].clone();
            for (int i = 0; i < j; i++) {
                r[i][j] = dot(q[i], q[j]);
                q[j] = Combination.plus(q[j], -r[i][j], q[i]);
            }
            r[j][j] = Math.sqrt(dot(q[j], q[j]));
            double length = r[j][j];
            q[j] = Arrays.stream(q[j]).map(x -> x / length).toArray();
            right[j] = dot(q[j], expected);
        }
        for (int j = n - 1; j >= 0; j--) {
            for (int k = j + 1; k < n; k++) {
                right[j] -= r[j][k] * right[k];
            }
            right[j] /= r[j][j];
        }
        return right;
    }

    private static double dot(double[] x, double[] y) {
        return IntStream.range(0, Math.min(x.length, y.length)).mapToDouble(k -> x[k] * y[k]).sum();
    }
}
