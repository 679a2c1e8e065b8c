package deSolvers.linear;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Minimum-norm solutions of singular systems. */
class MinimumNormSolutionTest {
    private static final int N = 3;

    /** Solves A x = A (1, 2, 3), where A is the sum of u u^T over the first vectors u = (1, k, k^2). */
    private static double[] solve(int rank) {
        EnvelopeMatrix matrix = new EnvelopeMatrix();
        double[] b = new double[N];
        for (int row = 0; row < N; row++) {
            matrix.add(0);
            for (int column = 0; column <= row; column++) {
                double sum = 0;
                for (int k = 0; k < rank; k++) {
                    sum += Math.pow(k, row + column);
                }
                matrix.set(row, column, sum, sum);
                b[row] += sum * (column + 1);
                b[column] += row == column ? 0 : sum * (row + 1);
            }
        }
        double[] x = new double[N];
        MinimumNormSolution.solve(matrix, new boolean[] {true, true, true}, b, x, 1e-11);
        double[] residual = new double[N];
        matrix.residual(x, b, residual);
        assertArrayEquals(new double[N], residual, 1e-13, "measured: 1.1e-14");
        return x;
    }

    /** Rods whose ends are all held by friction have a matrix of zeros. */
    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 3})
    void theSolutionIsTheShortest(int rank) {
        // of (1, 2, 3) what lies in the span of (1, 0, 0), (1, 1, 1) and (1, 2, 4): 2.5 is the mean of 2 and 3
        double[][] parts = {{0, 0, 0}, {1, 0, 0}, {1, 2.5, 2.5}, {1, 2, 3}};
        assertArrayEquals(parts[rank], solve(rank), 4e-13, "measured: 4.8e-14");
    }
}
