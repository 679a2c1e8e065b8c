package deSolvers.implicit;

import deSolvers.StepTransaction;
import deSolvers.linear.SolverWork;
import org.ejml.data.DMatrixRMaj;
import org.ejml.data.ZMatrixRMaj;
import org.ejml.dense.row.factory.LinearSolverFactory_DDRM;
import org.ejml.dense.row.factory.LinearSolverFactory_ZDRM;
import org.ejml.interfaces.linsol.LinearSolverDense;

/** I - g J as a full matrix, with J column by column from forward differences, at one evaluation each. */
final class DenseSystem implements ShiftedJacobian {
    /** Half the digits: the best balance of rounding against curvature in a forward difference. */
    static final double ROOT_EPSILON = Math.sqrt(Math.ulp(1.0));
    /** An entry that is small and does not move is varied as if it were this part of the largest entry. */
    static final double SMALL_ENTRY = 1e-5;

    /** Smaller differences would lose their digits to underflow. */
    private static final double SMALLEST_DELTA = 1e-290;
    /** A unit counts as no less than this part of the largest one. */
    private static final double SMALL_UNIT = 1e-3;

    private final int n;
    private final SolverWork work;
    private final LinearSolverDense<DMatrixRMaj> real;
    private final LinearSolverDense<ZMatrixRMaj> complex;
    private final double[] unit;                        // the size of each unknown, plus how far it moves in h
    private final double[] varied;
    private final double[] column;
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
        this.work = work;
        real = LinearSolverFactory_DDRM.lu(n);
        complex = LinearSolverFactory_ZDRM.lu(n);
        unit = new double[n];
        varied = new double[n];
        column = new double[n];
        jacobian = new double[n * n];
        matrix = new DMatrixRMaj(n, n);
        right = new DMatrixRMaj(n, 1);
        solution = new DMatrixRMaj(n, 1);
        complexRight = new ZMatrixRMaj(n, 1);
        complexSolution = new ZMatrixRMaj(n, 1);
    }

    /**
     * {@inheritDoc} With {@link Kind#CAREFUL} an entry that is far smaller than others is varied by a part of itself:
     * it may be a sum of large entries that cancel, where less than a part of the largest is lost to round-off; or f
     * may bend there.
     */
    @Override
    public void setJacobian(StepTransaction source, double[] state, double[] slope, double h, Kind kind) {
        work.jacobians++;
        double largest = NewtonUpdate.largest(state);
        System.arraycopy(state, 0, varied, 0, n);
        for (int j = 0; j < n; j++) {
            double move = Math.abs(h * slope[j]);
            double scale = Math.abs(state[j]);
            unit[j] = scale + move;
            if (kind != Kind.CAREFUL || scale == 0) {
                scale = Math.max(scale, Math.max(move, SMALL_ENTRY * largest));
            }
            if (scale == 0) {
                scale = 1;
            }
            varied[j] = state[j] + Math.copySign(Math.max(ROOT_EPSILON * scale, SMALLEST_DELTA), h * slope[j]);
            double delta = varied[j] - state[j];        // as rounded, so that the difference is exact
            source.setState(varied);
            source.getStateDerivative(column);
            for (int i = 0; i < n; i++) {
                jacobian[i * n + j] = (column[i] - slope[i]) / delta;
            }
            varied[j] = state[j];
        }
    }

    /** Differences vary small entries by a part of the largest. */
    @Override
    public boolean seesSmallEntries(double[] m) {
        boolean all = true;
        double small = SMALL_ENTRY * NewtonUpdate.largest(m);
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
        keepConstant(b, x);
        return StepTransaction.firstNonFinite(x) < 0;
    }

    @Override
    public boolean solveComplex(double[][] b, double[][] x, double tolerance) {
        for (int k = 0; k < 2 * n; k++) {
            complexRight.data[k] = b[k % 2][k / 2];
        }
        if (n > 0) {
            complex.solve(complexRight, complexSolution);
        }
        for (int k = 0; k < 2 * n; k++) {
            x[k % 2][k / 2] = complexSolution.data[k];
        }
        keepConstant(b[0], x[0]);
        keepConstant(b[1], x[1]);
        return StepTransaction.firstNonFinite(complexSolution.data) < 0;
    }

    /** Where f does not depend on the state, x = b: the elimination would move a fixed particle by its round-off. */
    private void keepConstant(double[] b, double[] x) {
        for (int i = 0; i < n; i++) {
            boolean constant = true;
            for (int at = i * n; at < (i + 1) * n && constant; at++) {
                constant = jacobian[at] == 0;
            }
            x[i] = constant ? b[i] : x[i];
        }
    }

    /** {@inheritDoc} A scalar product in the unknowns' units. */
    @Override
    public double slope(double[] residual, double[] solution, double[] direction) {
        double smallest = Math.max(Double.MIN_NORMAL, SMALL_UNIT * NewtonUpdate.largest(unit));
        double sum = 0;
        for (int i = 0; i < n; i++) {
            double u = Math.max(unit[i], smallest);
            sum += solution[i] / u * (direction[i] / u);
        }
        return sum;
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
