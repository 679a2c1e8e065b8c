package deSolvers.implicit;

import deSolvers.DEStateSource;
import deSolvers.GuardedStep;
import deSolvers.JacobianStateSource;
import java.util.Arrays;

/**
 * The stage equation m = s + g f(m) of a large source of any kind: Newton-Krylov without a matrix. GMRES needs nothing but
 * products J w, which the source computes or one difference of derivatives approximates.
 *
 * <p>Source: D. A. Knoll, D. E. Keyes (2004), J. Comput. Phys. 193, 357.
 */
final class KrylovProblem implements NewtonProblem, LinearOperator {
    private static final int MOST_ITERATIONS = 2000;
    private static final double ROOT_EPSILON = Math.sqrt(Math.ulp(1.0));
    private static final double ROUNDING = 2 * Math.ulp(1.0);

    private final ImplicitWork.Counter work;
    private final Gmres gmres;
    private GuardedStep source;
    private DEStateSource client;
    private double[] start;
    private double gamma;
    private double linearTolerance;
    private double[] base = {};
    private double[] baseRate = {};
    private double[] dSdt = {};
    private double[] varied = {};

    KrylovProblem(ImplicitWork.Counter work) {
        this.work = work;
        this.gmres = new Gmres(work);
    }

    /** Takes up the equation of one step; {@code start} is read as long as it is worked on. */
    void begin(GuardedStep source, DEStateSource client, double[] start, double gamma, double linearTolerance) {
        this.linearTolerance = linearTolerance;
        this.source = source;
        this.client = client;
        this.start = start;
        this.gamma = gamma;
        int n = start.length;
        if (base.length != n) {
            base = new double[n];
            baseRate = new double[n];
            dSdt = new double[n];
            varied = new double[n];
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
        System.arraycopy(m, 0, base, 0, m.length);
        System.arraycopy(dSdt, 0, baseRate, 0, m.length);
        work.jacobians++;
    }

    @Override
    public boolean correct(double[] residual, double[] correction) {
        if (client instanceof JacobianStateSource) {
            source.setState(base);
        }
        return gmres.solve(this, KrylovProblem::copy, residual, correction, linearTolerance, MOST_ITERATIONS);
    }

    private static void copy(double[] x, double[] y) {
        System.arraycopy(x, 0, y, 0, x.length);
    }

    /** y = x - g J x. */
    @Override
    public void apply(double[] x, double[] y) {
        if (client instanceof JacobianStateSource) {
            work.products++;
            ((JacobianStateSource) client).getJacobianProduct(x, y);
            for (int i = 0; i < x.length; i++) {
                y[i] = x[i] - gamma * y[i];
            }
            return;
        }
        double length = Gmres.norm(x);
        if (length == 0) {
            Arrays.fill(y, 0);
            return;
        }
        double scale = Math.max(Gmres.norm(base), Math.abs(gamma) * Gmres.norm(baseRate));
        double delta = ROOT_EPSILON * (scale == 0 ? 1 : scale) / length;
        for (int i = 0; i < x.length; i++) {
            varied[i] = base[i] + delta * x[i];
        }
        source.setState(varied);
        source.getStateDerivative(y);
        for (int i = 0; i < x.length; i++) {
            y[i] = x[i] - gamma * ((y[i] - baseRate[i]) / delta);
        }
    }

    /** Without a matrix only the rounding of the sum itself is known. */
    @Override
    public void rounding(double[] m, double[] floor) {
        for (int i = 0; i < m.length; i++) {
            floor[i] = ROUNDING * (Math.abs(start[i]) + Math.abs(m[i]) + Math.abs(gamma * dSdt[i]));
        }
    }
}
