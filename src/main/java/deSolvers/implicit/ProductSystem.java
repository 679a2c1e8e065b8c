package deSolvers.implicit;

import deSolvers.StepTransaction;
import deSolvers.linear.Gmres;
import deSolvers.linear.LinearOperator;

/**
 * I - g J of a large source that offers no blocks, by GMRES with products J w and without a matrix; the complex system
 * as a real one of twice the size. GMRES sees every unknown in units of its own size, so that small ones count as much
 * as large ones.
 *
 * <p>Source: D. A. Knoll, D. E. Keyes (2004), J. Comput. Phys. 193, 357.
 */
final class ProductSystem implements ShiftedJacobian {
    private final ImplicitWork.Counter work;
    private final int n;
    private final DirectionalDerivative derivative;
    private final Gmres gmres;
    private final Gmres complexGmres;
    private final LinearOperator real = this::applyReal;
    private final LinearOperator complex = this::applyComplex;
    private final double[] unit;                        // of each unknown
    private final double[] realRight;
    private final double[] complexRight;
    private final double[] part;
    private final double[] product;
    private double g;
    private double gRe;
    private double gIm;

    /** @param n the state's size */
    ProductSystem(ImplicitWork.Counter work, int n) {
        this.work = work;
        this.n = n;
        derivative = new DirectionalDerivative(work);
        gmres = new Gmres(work.linear);
        complexGmres = new Gmres(work.linear);
        unit = new double[n];
        realRight = new double[n];
        complexRight = new double[2 * n];
        part = new double[n];
        product = new double[n];
    }

    @Override
    public void setJacobian(StepTransaction source, double[] state, double[] slope, double h, Kind kind) {
        work.jacobians++;
        derivative.setBase(source, state, slope, h);
        NewtonUpdate.units(state, slope, h, unit);
    }

    /** Without a matrix J belongs to the place where the source is. */
    @Override
    public boolean keepsJacobian() {
        return false;
    }

    @Override
    public boolean prepare(double g) {
        this.g = g;
        return true;
    }

    @Override
    public boolean prepareComplex(double gRe, double gIm) {
        this.gRe = gRe;
        this.gIm = gIm;
        return true;
    }

    @Override
    public boolean solve(double[] b, double[] x, double tolerance) {
        return solve(gmres, real, 1, b, x, tolerance);
    }

    @Override
    public boolean solveComplex(double[] b, double[] x, double tolerance) {
        return solve(complexGmres, complex, 2, b, x, tolerance);
    }

    private boolean solve(Gmres gmres, LinearOperator operator, int doubles, double[] b, double[] x, double tolerance) {
        double[] scaled = doubles == 1 ? realRight : complexRight;
        for (int i = 0; i < b.length; i++) {
            scaled[i] = b[i] / unit[i / doubles];
        }
        boolean solved = gmres.solve(operator, LinearOperator.IDENTITY, scaled, x, tolerance);
        for (int i = 0; i < b.length; i++) {
            x[i] *= unit[i / doubles];
        }
        return solved;
    }

    private void applyReal(double[] x, double[] y) {
        multiply(x, 1, 0);
        for (int i = 0; i < n; i++) {
            y[i] = x[i] - g * product[i];
        }
    }

    /** J is real: it acts on real and imaginary parts alike. */
    private void applyComplex(double[] x, double[] y) {
        System.arraycopy(x, 0, y, 0, 2 * n);
        for (int half = 0; half < 2; half++) {
            multiply(x, 2, half);
            for (int i = 0; i < n; i++) {
                y[2 * i] -= (half == 0 ? gRe : -gIm) * product[i];
                y[2 * i + 1] -= (half == 0 ? gIm : gRe) * product[i];
            }
        }
    }

    /** The product of J with every so-many-th entry, in and out in the unknowns' units. */
    private void multiply(double[] x, int doubles, int half) {
        for (int i = 0; i < n; i++) {
            part[i] = unit[i] * x[doubles * i + half];
        }
        derivative.multiply(part, product);
        for (int i = 0; i < n; i++) {
            product[i] /= unit[i];
        }
    }

    @Override
    public double slope(double[] residual, double[] solution, double[] direction) {
        return NewtonUpdate.product(solution, direction, unit);
    }

    /** Without a matrix only the sum itself is known. */
    @Override
    public void terms(double[] state, double[] slope, double g, double[] size) {
        for (int i = 0; i < n; i++) {
            size[i] = Math.abs(g * slope[i]);
        }
    }
}
