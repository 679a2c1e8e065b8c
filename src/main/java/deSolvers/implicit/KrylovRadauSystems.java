package deSolvers.implicit;

import deSolvers.StepTransaction;
import deSolvers.linear.Gmres;
import deSolvers.linear.ImplicitWork;
import deSolvers.linear.LinearOperator;

/** The systems of large sources, solved by GMRES with products J w; the complex one as a real one of twice the size. */
final class KrylovRadauSystems implements RadauSystems {
    /**
     * A hundredth of what a correction has to be good for, so that Newton's iteration converges as with exact
     * solutions.
     */
    private static final double TOLERANCE = 1e-5;
    private static final int MOST_ITERATIONS = 1000;

    private final ImplicitWork.Counter work;
    private final int n;
    private final DirectionalDerivative derivative;
    private final Gmres realGmres;
    private final Gmres complexGmres;
    private final LinearOperator real = this::applyReal;
    private final LinearOperator complex = this::applyComplex;
    private final double[] part;
    private final double[] product;
    private StepTransaction source;
    private double offset;
    private double h;
    private double mu;
    private double muRe;
    private double muIm;

    KrylovRadauSystems(ImplicitWork.Counter work, int n) {
        this.work = work;
        this.n = n;
        derivative = new DirectionalDerivative(work);
        realGmres = new Gmres(work);
        complexGmres = new Gmres(work);
        part = new double[n];
        product = new double[n];
    }

    @Override
    public void setJacobian(StepTransaction source, double[] state, double[] slope, double offset, double h) {
        this.source = source;
        this.offset = offset;
        work.jacobians++;
        derivative.setBase(source, state, slope, h);
    }

    /** Without a matrix the Jacobian is where the source is, and is taken up anew with each sub-step. */
    @Override
    public boolean keepsJacobian() {
        return false;
    }

    @Override
    public boolean prepare(double h, double mu, double muRe, double muIm) {
        this.h = h;
        this.mu = mu;
        this.muRe = muRe;
        this.muIm = muIm;
        return true;
    }

    @Override
    public boolean solveReal(double[] b, double[] x) {
        source.setOffset(offset);
        return realGmres.solve(real, LinearOperator.IDENTITY, b, x, TOLERANCE, MOST_ITERATIONS);
    }

    @Override
    public boolean solveComplex(double[] b, double[] x) {
        source.setOffset(offset);
        return complexGmres.solve(complex, LinearOperator.IDENTITY, b, x, TOLERANCE, MOST_ITERATIONS);
    }

    private void applyReal(double[] x, double[] y) {
        derivative.multiply(x, y);
        for (int i = 0; i < n; i++) {
            y[i] = mu * x[i] - h * y[i];
        }
    }

    /** J is real: it acts on the real and on the imaginary part alone. */
    private void applyComplex(double[] x, double[] y) {
        for (int half = 0; half < 2; half++) {
            for (int i = 0; i < n; i++) {
                part[i] = x[2 * i + half];
            }
            derivative.multiply(part, product);
            for (int i = 0; i < n; i++) {
                y[2 * i + half] = -h * product[i];
            }
        }
        for (int i = 0; i < n; i++) {
            y[2 * i] += muRe * x[2 * i] - muIm * x[2 * i + 1];
            y[2 * i + 1] += muRe * x[2 * i + 1] + muIm * x[2 * i];
        }
    }
}
