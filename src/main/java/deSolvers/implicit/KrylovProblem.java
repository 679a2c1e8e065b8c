package deSolvers.implicit;

import deSolvers.GuardedStep;

/**
 * The stage equation m = s + g f(m) of a large source of any kind: Newton-Krylov without a matrix. GMRES needs nothing but
 * products J w, which the source computes or one difference of derivatives approximates.
 *
 * <p>Source: D. A. Knoll, D. E. Keyes (2004), J. Comput. Phys. 193, 357.
 */
final class KrylovProblem implements NewtonProblem, LinearOperator {
    private static final int MOST_ITERATIONS = 2000;
    private static final double ROUNDING = 2 * Math.ulp(1.0);

    private final ImplicitWork.Counter work;
    private final Gmres gmres;
    private final DirectionalDerivative derivative;
    private GuardedStep source;
    private double[] start;
    private double gamma;
    private double linearTolerance;
    private double[] dSdt = {};

    KrylovProblem(ImplicitWork.Counter work) {
        this.work = work;
        gmres = new Gmres(work);
        derivative = new DirectionalDerivative(work);
    }

    /** Takes up the equation of one step; {@code start} is read as long as it is worked on. */
    void begin(GuardedStep source, double[] start, double gamma, double linearTolerance) {
        this.source = source;
        this.start = start;
        this.gamma = gamma;
        this.linearTolerance = linearTolerance;
        if (dSdt.length != start.length) {
            dSdt = new double[start.length];
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
        work.jacobians++;
        derivative.setBase(source, m, dSdt, gamma);
    }

    @Override
    public boolean correct(double[] residual, double[] correction) {
        return gmres.solve(this, LinearOperator.IDENTITY, residual, correction, linearTolerance, MOST_ITERATIONS);
    }

    /** y = x - g J x. */
    @Override
    public void apply(double[] x, double[] y) {
        derivative.multiply(x, y);
        for (int i = 0; i < x.length; i++) {
            y[i] = x[i] - gamma * y[i];
        }
    }

    /** Without a matrix only the rounding of the sum itself is known. */
    @Override
    public void rounding(double[] m, double[] floor) {
        for (int i = 0; i < m.length; i++) {
            floor[i] = Double.MIN_NORMAL + ROUNDING * (Math.abs(start[i]) + Math.abs(m[i]) + Math.abs(gamma * dSdt[i]));
        }
    }
}
