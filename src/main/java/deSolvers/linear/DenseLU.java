package deSolvers.linear;

import deSolvers.FiniteCheck;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.factory.LinearSolverFactory_DDRM;
import org.ejml.interfaces.linsol.LinearSolverDense;

/** The LU factorisation of a full matrix with partial pivoting, by EJML. */
public final class DenseLU implements LinearSolver {
    private final LinearWork work;
    private final int n;
    private final LinearSolverDense<DMatrixRMaj> lu;
    private final DMatrixRMaj matrix = new DMatrixRMaj();
    private final DMatrixRMaj right = new DMatrixRMaj();
    private final DMatrixRMaj solution = new DMatrixRMaj();
    private boolean regular;

    /**
     * @param work counts the factorisations
     * @param n    rows and columns
     */
    public DenseLU(LinearWork work, int n) {
        this.work = work;
        this.n = n;
        lu = LinearSolverFactory_DDRM.lu(n);
    }

    /**
     * Factorises a matrix.
     *
     * @param matrix n<sup>2</sup> entries by rows; not changed
     * @return false if it is singular
     */
    public boolean factorise(double[] matrix) {
        work.factorisations++;
        regular = n == 0 || lu.setA(wrap(this.matrix, matrix, n));
        return regular;
    }

    @Override
    public boolean solve(double[] b, double[] x, double tolerance) {
        if (n > 0 && regular) {
            lu.solve(wrap(right, b, 1), wrap(solution, x, 1));
        }
        return regular && FiniteCheck.firstNonFinite(x) < 0;
    }

    private DMatrixRMaj wrap(DMatrixRMaj wrapper, double[] entries, int columns) {
        wrapper.data = entries;
        wrapper.numRows = n;
        wrapper.numCols = columns;
        return wrapper;
    }
}
