package deSolvers.implicit;

import deSolvers.DEStateSource;
import deSolvers.FiniteCheck;
import deSolvers.StepTransaction;
import deSolvers.linear.ImplicitWork;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.factory.LinearSolverFactory_DDRM;
import org.ejml.interfaces.linsol.LinearSolverDense;

/** The stage equation m = s + g f(m) of a small source: the matrix I - g J is full and factorised. */
final class DenseProblem implements NewtonProblem {
    /** Rounding of a sum of products, each correct to half a unit in the last place. */
    private static final double ROUNDING = 2 * Math.ulp(1.0);

    private final ImplicitWork.Counter work;
    private final DenseJacobian differences;
    private StepTransaction source;
    private DEStateSource client;
    private double[] start;
    private double gamma;
    private double[] dSdt = {};
    private DMatrixRMaj jacobian;
    private DMatrixRMaj matrix;
    private LinearSolverDense<DMatrixRMaj> lu;
    private final DMatrixRMaj right = new DMatrixRMaj();
    private final DMatrixRMaj solution = new DMatrixRMaj();
    private boolean regular;

    DenseProblem(ImplicitWork.Counter work) {
        this.work = work;
        this.differences = new DenseJacobian(work);
    }

    /** Takes up the equation of one step; {@code start} is read as long as it is worked on. */
    void begin(StepTransaction source, DEStateSource client, double[] start, double gamma) {
        this.source = source;
        this.client = client;
        this.start = start;
        this.gamma = gamma;
        differences.setFine(false);
        int n = start.length;
        if (dSdt.length != n) {
            dSdt = new double[n];
            jacobian = new DMatrixRMaj(n, n);
            matrix = new DMatrixRMaj(n, n);
            lu = LinearSolverFactory_DDRM.lu(n);
        }
    }

    @Override
    public int size() {
        return start.length;
    }

    @Override
    public void evaluate(double[] m, double[] residual) {
        source.setState(m);
        source.getStateDerivative(dSdt);
        for (int i = 0; i < m.length; i++) {
            residual[i] = start[i] - m[i] + gamma * dSdt[i];
        }
    }

    @Override
    public void linearise(double[] m) {
        differences.compute(source, client, m, dSdt, gamma, jacobian);
        int n = m.length;
        for (int at = 0; at < n * n; at++) {
            matrix.data[at] = -gamma * jacobian.data[at];
        }
        for (int i = 0; i < n; i++) {
            matrix.data[i * n + i] += 1;
        }
        work.factorisations++;
        regular = lu.setA(matrix);
    }

    @Override
    public boolean correct(double[] residual, double[] correction) {
        if (!regular) {
            return false;
        }
        right.setData(residual);
        right.numRows = residual.length;
        right.numCols = 1;
        solution.setData(correction);
        solution.numRows = residual.length;
        solution.numCols = 1;
        lu.solve(right, solution);
        return FiniteCheck.firstNonFinite(correction) < 0;
    }

    @Override
    public void rounding(double[] m, double[] floor) {
        int n = m.length;
        for (int i = 0; i < n; i++) {
            double sum = 0;
            for (int j = 0; j < n; j++) {
                sum += Math.abs(jacobian.data[i * n + j]) * Math.abs(m[j]);
            }
            floor[i] = Double.MIN_NORMAL + ROUNDING * (Math.abs(start[i]) + Math.abs(m[i]) + Math.abs(gamma) * sum);
        }
    }

    /** Small unknowns are varied by as little as they are: their differences are not those of a place far off. */
    @Override
    public void refine(double[] m) {
        differences.setFine(true);
    }
}
