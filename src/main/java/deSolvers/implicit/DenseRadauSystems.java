package deSolvers.implicit;

import deSolvers.FiniteCheck;
import deSolvers.StepTransaction;
import deSolvers.linear.ImplicitWork;
import org.ejml.data.DMatrixRMaj;
import org.ejml.data.ZMatrixRMaj;
import org.ejml.dense.row.factory.LinearSolverFactory_DDRM;
import org.ejml.dense.row.factory.LinearSolverFactory_ZDRM;
import org.ejml.interfaces.linsol.LinearSolverDense;

/** The systems of small sources, as full matrices that are factorised. */
final class DenseRadauSystems implements RadauSystems {
    private final ImplicitWork.Counter work;
    private final DenseJacobian differences;
    private final int n;
    private final DMatrixRMaj jacobian;
    private final DMatrixRMaj real;
    private final ZMatrixRMaj complex;
    private final LinearSolverDense<DMatrixRMaj> realLU;
    private final LinearSolverDense<ZMatrixRMaj> complexLU;
    private final DMatrixRMaj realRight = new DMatrixRMaj();
    private final DMatrixRMaj realSolution = new DMatrixRMaj();
    private final ZMatrixRMaj complexRight = new ZMatrixRMaj(1, 1);
    private final ZMatrixRMaj complexSolution = new ZMatrixRMaj(1, 1);

    DenseRadauSystems(ImplicitWork.Counter work, int n) {
        this.work = work;
        this.n = n;
        differences = new DenseJacobian(work);
        jacobian = new DMatrixRMaj(n, n);
        real = new DMatrixRMaj(n, n);
        complex = new ZMatrixRMaj(n, n);
        realLU = LinearSolverFactory_DDRM.lu(n);
        complexLU = LinearSolverFactory_ZDRM.lu(n);
    }

    @Override
    public void setJacobian(StepTransaction source, double[] state, double[] slope, double offset, double h) {
        source.setOffset(offset);
        differences.compute(source, source.getClient(), state, slope, h, jacobian);
    }

    @Override
    public boolean keepsJacobian() {
        return true;
    }

    @Override
    public boolean prepare(double h, double mu, double muRe, double muIm) {
        for (int at = 0; at < n * n; at++) {
            double entry = -h * jacobian.data[at];
            real.data[at] = entry;
            complex.data[2 * at] = entry;
            complex.data[2 * at + 1] = 0;
        }
        for (int i = 0; i < n; i++) {
            int at = i * (n + 1);
            real.data[at] += mu;
            complex.data[2 * at] += muRe;
            complex.data[2 * at + 1] += muIm;
        }
        work.factorisations += 2;
        return n == 0 || realLU.setA(real) && complexLU.setA(complex);
    }

    @Override
    public boolean solveReal(double[] b, double[] x) {
        realRight.setData(b);
        realRight.numRows = n;
        realRight.numCols = 1;
        realSolution.setData(x);
        realSolution.numRows = n;
        realSolution.numCols = 1;
        if (n > 0) {
            realLU.solve(realRight, realSolution);
        }
        return FiniteCheck.firstNonFinite(x) < 0;
    }

    @Override
    public boolean solveComplex(double[] b, double[] x) {
        complexRight.data = b;
        complexRight.numRows = n;
        complexRight.numCols = 1;
        complexSolution.data = x;
        complexSolution.numRows = n;
        complexSolution.numCols = 1;
        if (n > 0) {
            complexLU.solve(complexRight, complexSolution);
        }
        return FiniteCheck.firstNonFinite(x) < 0;
    }
}
