package deSolvers.implicit;

import deSolvers.DEStateSource;
import deSolvers.JacobianStateSource;
import deSolvers.StepTransaction;
import deSolvers.linear.ComplexDenseLU;
import deSolvers.linear.DenseLU;

/** I - g J as a full matrix, for small sources. */
final class DenseSystem implements ShiftedJacobian {
    private final int n;
    private final DenseJacobian differences;
    private final DenseLU real;
    private final ComplexDenseLU complex;
    private final double[] unit;
    private final double[] jacobian;
    private final double[] matrix;
    private final double[] complexMatrix;
    private DEStateSource client;

    /** @param n the state's size */
    DenseSystem(ImplicitWork.Counter work, int n) {
        this.n = n;
        differences = new DenseJacobian(work);
        real = new DenseLU(work.linear, n);
        complex = new ComplexDenseLU(work.linear, n);
        unit = new double[n];
        jacobian = new double[n * n];
        matrix = new double[n * n];
        complexMatrix = new double[2 * n * n];
    }

    @Override
    public void setJacobian(StepTransaction source, double[] state, double[] slope, double h, Kind kind) {
        differences.compute(source, state, slope, h, kind == Kind.CAREFUL, jacobian);
        this.client = source.getClient();
        NewtonUpdate.units(state, slope, h, unit);
    }

    /** Differences vary small entries by a part of the largest. */
    @Override
    public boolean seesSmallEntries(double[] m) {
        boolean all = true;
        double small = DenseJacobian.SMALL_ENTRY * NewtonUpdate.largest(m);
        for (int i = 0; i < n && !(client instanceof JacobianStateSource); i++) {
            all &= m[i] == 0 || Math.abs(m[i]) >= small;
        }
        return all;
    }

    @Override
    public boolean keepsJacobian() {
        return true;
    }

    @Override
    public boolean prepare(double g) {
        for (int at = 0; at < n * n; at++) {
            matrix[at] = -g * jacobian[at] + (at % (n + 1) == 0 ? 1 : 0);
        }
        return real.factorise(matrix);
    }

    @Override
    public boolean prepareComplex(double gRe, double gIm) {
        for (int at = 0; at < n * n; at++) {
            complexMatrix[2 * at] = -gRe * jacobian[at] + (at % (n + 1) == 0 ? 1 : 0);
            complexMatrix[2 * at + 1] = -gIm * jacobian[at];
        }
        return complex.factorise(complexMatrix);
    }

    @Override
    public boolean solve(double[] b, double[] x, double tolerance) {
        return real.solve(b, x, tolerance);
    }

    @Override
    public boolean solveComplex(double[] b, double[] x, double tolerance) {
        return complex.solve(b, x, tolerance);
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
