package deSolvers.implicit;

import deSolvers.FiniteCheck;
import deSolvers.StepTransaction;
import deSolvers.linear.SolverWork;
import org.ejml.data.DMatrixRMaj;
import org.ejml.data.ZMatrixRMaj;
import org.ejml.dense.row.factory.LinearSolverFactory_DDRM;
import org.ejml.dense.row.factory.LinearSolverFactory_ZDRM;
import org.ejml.interfaces.linsol.LinearSolverDense;

/** I - g J as a full matrix. */
final class DenseSystem implements ShiftedJacobian {
    private final int n;
    private final DenseJacobian differences;
    private final SolverWork work;
    private final LinearSolverDense<DMatrixRMaj> real;
    private final LinearSolverDense<ZMatrixRMaj> complex;
    private final double[] unit;
    private final double[] jacobian;
    private final DMatrixRMaj matrix;
    private final DMatrixRMaj right;
    private final DMatrixRMaj solution;
    private final ZMatrixRMaj complexMatrix = new ZMatrixRMaj(0, 0);
    private final ZMatrixRMaj complexRight;
    private final ZMatrixRMaj complexSolution;

    /** @param n the state's size */
    DenseSystem(SolverWork work, int n) {
        this.n = n;
        differences = new DenseJacobian(work);
        this.work = work;
        real = LinearSolverFactory_DDRM.lu(n);
        complex = LinearSolverFactory_ZDRM.lu(n);
        unit = new double[n];
        jacobian = new double[n * n];
        matrix = new DMatrixRMaj(n, n);
        right = new DMatrixRMaj(n, 1);
        solution = new DMatrixRMaj(n, 1);
        complexRight = new ZMatrixRMaj(n, 1);
        complexSolution = new ZMatrixRMaj(n, 1);
    }

    @Override
    public void setJacobian(StepTransaction source, double[] state, double[] slope, double h, Kind kind) {
        differences.compute(source, state, slope, h, kind == Kind.CAREFUL, jacobian);
        NewtonUpdate.units(state, slope, h, unit);
    }

    /** Differences vary small entries by a part of the largest. */
    @Override
    public boolean seesSmallEntries(double[] m) {
        boolean all = true;
        double small = DenseJacobian.SMALL_ENTRY * NewtonUpdate.largest(m);
        for (int i = 0; i < n; i++) {
            all &= m[i] == 0 || Math.abs(m[i]) >= small;
        }
        return all;
    }

    @Override
    public boolean prepare(double g) {
        for (int at = 0; at < n * n; at++) {
            matrix.data[at] = -g * jacobian[at] + (at % (n + 1) == 0 ? 1 : 0);
        }
        work.factorisations++;
        return n == 0 || real.setA(matrix);
    }

    @Override
    public boolean prepareComplex(double gRe, double gIm) {
        complexMatrix.reshape(n, n);                    // twice the others' size, and only radau needs it
        for (int at = 0; at < n * n; at++) {
            complexMatrix.data[2 * at] = -gRe * jacobian[at] + (at % (n + 1) == 0 ? 1 : 0);
            complexMatrix.data[2 * at + 1] = -gIm * jacobian[at];
        }
        work.factorisations++;
        return n == 0 || complex.setA(complexMatrix);
    }

    @Override
    public boolean solve(double[] b, double[] x, double tolerance) {
        right.data = b;
        solution.data = x;
        if (n > 0) {
            real.solve(right, solution);
        }
        return FiniteCheck.firstNonFinite(x) < 0;
    }

    @Override
    public boolean solveComplex(double[] b, double[] x, double tolerance) {
        complexRight.data = b;
        complexSolution.data = x;
        if (n > 0) {
            complex.solve(complexRight, complexSolution);
        }
        return FiniteCheck.firstNonFinite(x) < 0;
    }

    @Override
    public double slope(double[] residual, double[] solution, double[] direction) {
        return NewtonUpdate.product(solution, direction, unit);
    }

    @Override
    public void terms(double[] state, double[] slope, double g, double[] size) {
        for (int i = 0; i < n; i++) {
            double sum = 0;
            for (int j = 0; j < n; j++) {
                sum += Math.abs(jacobian[i * n + j]) * Math.abs(state[j]);
            }
            size[i] = Math.abs(g) * Math.max(sum, Math.abs(slope[i]));
        }
    }
}
