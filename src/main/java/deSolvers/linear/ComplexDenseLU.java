package deSolvers.linear;

import deSolvers.FiniteCheck;
import org.ejml.data.ZMatrixRMaj;
import org.ejml.dense.row.factory.LinearSolverFactory_ZDRM;
import org.ejml.interfaces.linsol.LinearSolverDense;

/** {@link DenseLU} for complex matrices and vectors: each entry is two doubles, its real and its imaginary part. */
public final class ComplexDenseLU implements LinearSolver {
    private final LinearWork work;
    private final int n;
    private final ZMatrixRMaj matrix = new ZMatrixRMaj(1, 1);
    private final LinearSolverDense<ZMatrixRMaj> lu;
    private final ZMatrixRMaj right = new ZMatrixRMaj(1, 1);
    private final ZMatrixRMaj solution = new ZMatrixRMaj(1, 1);
    private boolean regular;

    /**
     * @param work counts the factorisations
     * @param n    rows and columns
     */
    public ComplexDenseLU(LinearWork work, int n) {
        this.work = work;
        this.n = n;
        lu = LinearSolverFactory_ZDRM.lu(n);
    }

    /**
     * Factorises a matrix.
     *
     * @param entries 2 n<sup>2</sup> doubles by rows; not changed
     * @return false if it is singular
     */
    public boolean factorise(double[] entries) {
        work.factorisations++;
        regular = n == 0 || lu.setA(wrap(matrix, entries, n));
        return regular;
    }

    @Override
    public boolean solve(double[] b, double[] x, double tolerance) {
        if (n > 0 && regular) {
            lu.solve(wrap(right, b, 1), wrap(solution, x, 1));
        }
        return regular && FiniteCheck.firstNonFinite(x) < 0;
    }

    private ZMatrixRMaj wrap(ZMatrixRMaj wrapper, double[] entries, int columns) {
        wrapper.data = entries;
        wrapper.numRows = n;
        wrapper.numCols = columns;
        return wrapper;
    }
}
