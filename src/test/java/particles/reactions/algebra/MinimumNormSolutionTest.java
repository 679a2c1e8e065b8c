package particles.reactions.algebra;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Minimum-norm solutions of singular systems, one after another. */
class MinimumNormSolutionTest {
    private static final int N = 3;

    /** Solves A x = A (1, 2, 3), where A is the sum of u u^T over the first vectors u = (1, k, k^2). */
    private static double[] solve(MinimumNormSolution system, int rank) {
        system.begin(N);
        double[][] a = new double[N][N];
        double[] x = new double[N];
        for (int row = 0; row < N; row++) {
            for (int column = 0; column < N; column++) {
                for (int k = 0; k < rank; k++) {
                    a[row][column] += Math.pow(k, row + column);
                }
                system.set(row, column, a[row][column]);
                x[row] += a[row][column] * (column + 1);
            }
        }
        system.factorise();
        double[] b = x.clone();
        system.solve(x);
        for (int row = 0; row < N; row++) {
            assertEquals(b[row], a[row][0] * x[0] + a[row][1] * x[1] + a[row][2] * x[2], 1e-13, "measured: 1.1e-14");
        }
        return x;
    }

    /** Rods whose ends are all held by friction have a matrix of zeros, mostly after one that had none. */
    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 3})
    void theSolutionDoesNotDependOnTheMatrixBefore(int rank) {
        MinimumNormSolution used = new MinimumNormSolution();
        solve(used, N);
        double[] x = solve(used, rank);
        assertArrayEquals(solve(new MinimumNormSolution(), rank), x);
        // of (1, 2, 3) what lies in the span of (1, 0, 0), (1, 1, 1) and (1, 2, 4): 2.5 is the mean of 2 and 3
        double[][] parts = {{0, 0, 0}, {1, 0, 0}, {1, 2.5, 2.5}, {1, 2, 3}};
        assertArrayEquals(parts[rank], x, 4e-13, "measured: 4.8e-14");
    }
}
